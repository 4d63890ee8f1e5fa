#include "tm/clean/rounding/unite_close.h"

#include <doctest/doctest.h>

#include <map>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

Assembly as_assembly(const Mesh& mesh) {
  Assembly assembly;
  assembly.mesh = mesh;
  assembly.input_vertex.assign(mesh.positions.size(), no_index);
  assembly.vertex_is_new.assign(mesh.positions.size(), 0);
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) assembly.source_face.push_back(f);
  return assembly;
}

Mesh united(const Mesh& mesh, double distance) {
  Assembly assembly = as_assembly(mesh);
  CHECK(unite_close_parts(assembly, assembly.source_face, {distance}, Scalar::float64));
  CHECK(assembly.source_face.size() == assembly.mesh.faces.size());
  CHECK(assembly.face_is_new.size() == assembly.mesh.faces.size());
  CHECK(assembly.vertex_is_new.size() == assembly.mesh.positions.size());
  return assembly.mesh;
}

using Key = std::array<double, 3>;

Key key(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Per edge, how many faces more run one way than the other, by positions.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<Key, Key>, int> sums;
  for (const Face& f : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Key a = key(mesh.positions[f[i]]), b = key(mesh.positions[f[(i + 1) % 3]]);
      if (a < b) ++sums[{a, b}];
      if (b < a) --sums[{b, a}];
    }
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; });
}

/// Triangles as corner positions, oriented and unoriented ones alike.
std::map<std::array<Key, 3>, int> count_triangles(const Mesh& mesh) {
  std::map<std::array<Key, 3>, int> count;
  for (const Face& f : mesh.faces) {
    std::array<Key, 3> corners = {key(mesh.positions[f[0]]), key(mesh.positions[f[1]]),
                                  key(mesh.positions[f[2]])};
    std::sort(corners.begin(), corners.end());
    ++count[corners];
  }
  return count;
}

Mesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE("two triangles of a film end in the same triangles where they overlap") {
  const double gap = 1e-9;
  const Mesh film = test::joined(triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}),
                                 triangle({1, 1, gap}, {5, 1, gap}, {1, 5, 2 * gap}));
  const Mesh mesh = united(film, 3 * gap);
  std::size_t shared = 0;
  double area = 0;
  for (const auto& [corners, count] : count_triangles(mesh)) {
    if (count < 2) continue;
    ++shared;
    const auto at = [&](std::size_t i) {
      return Vec3(corners[i][0], corners[i][1], corners[i][2]);
    };
    area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
  }
  CHECK(shared > 0);
  CHECK(area == doctest::Approx(2));  // x, y >= 1 and x + y <= 4
  CHECK(united(film, gap / 8).faces.size() == film.faces.size());
}

TEST_CASE("a sliver whose corner lies on its own opposite edge vanishes") {
  CHECK(united(triangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}), 1e-8).faces.empty());
  CHECK(united(triangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}), 1e-10).faces.size() == 1);
}

TEST_CASE("what is closed stays closed, however much is united") {
  test::Random random(5);
  for (const double distance : {1e-6, 1e-2, 0.05}) {
    CAPTURE(distance);
    Mesh balls;
    for (int i = 0; i < 3; ++i)
      balls = test::joined(balls, test::moved(test::icosphere(2), random.point(-0.02, 0.02)));
    CHECK(is_closed(united(balls, distance)));
  }
}
