#include "corpus/build.h"

namespace transformesh::corpus {

std::string named(const std::string& name, long value) {
  return name + "-" + std::to_string(value);
}

long integer(Random& random, long low, long high) {
  return low + static_cast<long>(random.below(static_cast<std::uint64_t>(high - low + 1)));
}

Vec3 lattice_point(Random& random, long low, long high) {
  const auto x = static_cast<double>(integer(random, low, high));
  const auto y = static_cast<double>(integer(random, low, high));
  return {x, y, static_cast<double>(integer(random, low, high))};
}

Mesh lattice_box(Random& random, long size, long longest) {
  const Vec3 low = lattice_point(random, 0, size - 1);
  const Vec3 sides = lattice_point(random, 1, longest);
  return test::cuboid(low, (low + sides).cwiseMin(Vec3::Constant(static_cast<double>(size))));
}

Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return (b - a).cross(c - a).dot(d - a) > 0 ? mesh : test::reversed(mesh);
}

Mesh lattice_tetrahedron(Random& random, long low, long high) {
  for (;;) {
    const Vec3 a = lattice_point(random, low, high);
    const Vec3 b = lattice_point(random, low, high);
    const Vec3 c = lattice_point(random, low, high);
    const Vec3 d = lattice_point(random, low, high);
    if ((b - a).cross(c - a).dot(d - a) != 0) return tetrahedron(a, b, c, d);
  }
}

Mesh bipyramid(int sides, double radius, double height, double angle) {
  Mesh mesh;
  mesh.positions = {{0, 0, -height}, {0, 0, height}};
  const auto ring = [&](int i) { return static_cast<Index>(2 + i % sides); };
  for (int i = 0; i < sides; ++i) {
    const double turn = angle + 2 * std::numbers::pi * i / sides;
    mesh.positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0);
    mesh.faces.push_back({0, ring(i + 1), ring(i)});
    mesh.faces.push_back({1, ring(i), ring(i + 1)});
  }
  return mesh;
}

Mesh turned(Mesh mesh, double angle) {
  const Eigen::AngleAxisd rotation(angle, Vec3(0.48, 0.6, 0.64));
  for (Vec3& position : mesh.positions) position = rotation * position;
  return mesh;
}

Mesh stretched(Mesh mesh, const Vec3& by) {
  for (Vec3& position : mesh.positions) position = position.cwiseProduct(by);
  return mesh;
}

Mesh on_lattice(Mesh mesh) {
  for (Vec3& position : mesh.positions) position = position.array().round().matrix();
  return mesh;
}

Mesh jittered(Mesh mesh, double amplitude, Random& random) {
  for (Vec3& position : mesh.positions) position += random.point(-amplitude, amplitude);
  return mesh;
}

}  // namespace transformesh::corpus
