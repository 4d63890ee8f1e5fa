#include "corpus/hostile_shapes.h"

#include <cmath>
#include <numbers>

#include "corpus/build.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh::corpus {
namespace {

using Rotation = Eigen::AngleAxisd;

double epsilon_of(Scalar type) { return type == Scalar::float32 ? 0x1p-23 : 0x1p-52; }
/// The largest decimal exponent of coordinates in a family.
double largest_exponent(Scalar type) { return type == Scalar::float32 ? 30 : 150; }

Rotation any_rotation(Random& random) {
  const Vec3 axis = random.point(-1, 1).normalized();
  return Rotation(random.uniform(0, 2 * std::numbers::pi), axis);
}

Mesh rotated(Mesh mesh, const Rotation& rotation) {
  for (Vec3& p : mesh.positions) p = rotation * p;
  return mesh;
}

Vec3 unit_vector(Random& random) { return any_rotation(random) * Vec3::UnitX(); }

/// Returns a number of random sign with a decimal exponent in [low, high].
double of_magnitude(Random& random, double low, double high) {
  const double size = std::pow(10, random.uniform(low, high));
  return random.below(2) == 0 ? size : -size;
}

Mesh two_balls(Random& random, int subdivisions) {
  const Mesh ball = rotated(icosphere(subdivisions), any_rotation(random));
  const Mesh other = rotated(icosphere(subdivisions), any_rotation(random));
  return joined(ball, moved(other, random.uniform(0.3, 1.5) * unit_vector(random)));
}

/// Returns a tetrahedron that is oriented outwards for its corners as stored in doubles, whatever
/// its size.
Mesh any_tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return tetrahedron(a, b, c, d);
}

Mesh near_vertices(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const long places = integer(random, 4, 6);
  std::vector<Vec3> base;
  for (long i = 0; i < places; ++i) base.push_back(random.point(-1, 1));
  const auto corner = [&](std::size_t i) -> Vec3 {
    return base[i] + epsilon_of(type) * lattice_point(random, -3, 3);
  };
  Mesh mesh;
  for (long i = integer(random, 4, 12); i > 0; --i) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 4; ++k) corners.push_back(corner(random.below(base.size())));
    mesh = joined(mesh, any_tetrahedron(corners[0], corners[1], corners[2], corners[3]));
  }
  return mesh;
}

Mesh spike(std::uint64_t seed, Scalar type) {
  Random random(seed);
  Mesh mesh = two_balls(random, 1);
  Vec3& apex = mesh.positions[random.below(mesh.positions.size())];
  apex *= std::pow(10, random.uniform(0, largest_exponent(type)));
  return mesh;
}

Mesh far_coordinates(std::uint64_t seed, Scalar type) {
  Random random(seed);
  Mesh mesh = two_balls(random, 1);
  const double most = std::min(100.0, largest_exponent(type));
  for (long i = integer(random, 1, 3); i > 0; --i)
    mesh.positions[random.below(mesh.positions.size())][integer(random, 0, 2)] =
        of_magnitude(random, 0, most);
  return mesh;
}

Mesh plates_on_line(std::uint64_t seed, Scalar) {
  Random random(seed);
  const Rotation rotation = any_rotation(random);
  const double thickness = std::pow(10, random.uniform(-4, -1.5));
  Mesh mesh;
  for (long i = integer(random, 20, 53); i > 0; --i) {
    const Vec3 low(-1, -random.uniform(0.5, 1.5), -thickness), high = -low;
    mesh = joined(mesh, rotated(cuboid(low, high),
                                Rotation(random.uniform(0, std::numbers::pi), Vec3::UnitX())));
  }
  return rotated(mesh, rotation);
}

Mesh nearly_flat(std::uint64_t seed, Scalar type) {
  Random random(seed);
  Mesh mesh = random.below(2) == 0 ? icosphere(1) : torus(1, 0.5, 6, 5);
  const double height = epsilon_of(type) * std::pow(2, random.uniform(0, 8));
  for (Vec3& p : mesh.positions) {
    p = random.point(-1, 1);
    p.z() *= height;
  }
  return moved(rotated(mesh, any_rotation(random)), random.point(-0.1, 0.1));
}

Mesh stacked_plates(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const double unit = epsilon_of(type) * integer(random, 1, 6);
  Mesh mesh;
  const long plates = integer(random, 12, 50);
  for (long i = 0; i < plates; ++i) {
    const Vec3 low(-random.uniform(0.3, 1), -random.uniform(0.3, 1), unit * i);
    const Vec3 high(random.uniform(0.3, 1), random.uniform(0.3, 1),
                    unit * (i + integer(random, 1, 2)));
    const Rotation about(random.uniform(0, 7), Vec3::UnitZ());
    mesh = joined(mesh, rotated(cuboid(low, high), about));
  }
  return rotated(mesh, any_rotation(random));
}

Mesh needles_in_ball(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const double radius = std::pow(10, random.uniform(std::log10(epsilon_of(type)), -2));
  Mesh mesh;
  for (long i = integer(random, 30, 60); i > 0; --i) {
    const Vec3 along = unit_vector(random), middle = radius * random.point(-1, 1);
    const Vec3 across = radius * random.point(-1, 1), other = radius * random.point(-1, 1);
    mesh = joined(mesh,
                  any_tetrahedron(middle - along, middle + along, middle + across, middle + other));
  }
  return mesh;
}

Mesh tetrahedra_at_apex(std::uint64_t seed, Scalar) {
  Random random(seed);
  const Vec3 apex = random.point(-1, 1);
  Mesh mesh;
  for (long i = integer(random, 40, 150); i > 0; --i)
    mesh = joined(
        mesh, any_tetrahedron(apex, random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)));
  return mesh;
}

Mesh tetrahedra_at_edge(std::uint64_t seed, Scalar) {
  Random random(seed);
  const Vec3 from = random.point(-1, 1), to = random.point(-1, 1);
  Mesh mesh;
  for (long i = integer(random, 40, 150); i > 0; --i)
    mesh = joined(mesh, any_tetrahedron(from, to, random.point(-1, 1), random.point(-1, 1)));
  return mesh;
}

Mesh mixed_magnitudes(std::uint64_t seed, Scalar type, double share) {
  Random random(seed);
  Mesh mesh = two_balls(random, random.below(2) == 0 ? 0 : 1);
  const double most = largest_exponent(type);
  for (Vec3& p : mesh.positions)
    for (double& x : p)
      if (random.uniform(0, 1) < share) x = of_magnitude(random, -most, most);
  return mesh;
}

Mesh all_magnitudes(std::uint64_t seed, Scalar type) { return mixed_magnitudes(seed, type, 1); }
Mesh some_magnitudes(std::uint64_t seed, Scalar type) { return mixed_magnitudes(seed, type, 0.2); }

Mesh tetrahedra_of_magnitudes(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const double most = largest_exponent(type) / 3;
  Mesh mesh;
  for (long i = integer(random, 5, 25); i > 0; --i) {
    const double size = std::pow(10, random.uniform(-most, most));
    mesh = joined(mesh, any_tetrahedron(size * random.point(-1, 1), size * random.point(-1, 1),
                                        size * random.point(-1, 1), size * random.point(-1, 1)));
  }
  return mesh;
}

Mesh tilted_plates(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const Rotation rotation = any_rotation(random);
  Mesh mesh;
  for (long i = integer(random, 6, 40); i > 0; --i) {
    const double thickness = epsilon_of(type) * integer(random, 1, 8);
    const Vec3 low(-random.uniform(0.3, 1), -random.uniform(0.3, 1), -thickness), high = -low;
    const Rotation tilt(epsilon_of(type) * random.uniform(-8, 8), unit_vector(random));
    mesh = joined(mesh, rotated(rotated(cuboid(low, high), tilt), rotation));
  }
  return mesh;
}

Mesh sliver_fan(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const Rotation rotation = any_rotation(random);
  const double width = std::pow(10, random.uniform(std::log10(epsilon_of(type)) + 1, -2));
  Mesh mesh;
  for (long i = integer(random, 10, 60); i > 0; --i) {
    const Rotation turn(random.uniform(0, 7), Vec3::UnitZ());
    const Vec3 tip = turn * Vec3(1, 0, random.uniform(-0.2, 0.2));
    const Vec3 side = turn * Vec3(1, width, random.uniform(-0.2, 0.2));
    mesh = joined(mesh, any_tetrahedron({0, 0, -1}, {0, 0, 1}, tip, side));
  }
  return rotated(mesh, rotation);
}

Mesh lattice_tetrahedra(std::uint64_t seed, Scalar) {
  Random random(seed);
  const long values = integer(random, 2, 6);
  Mesh mesh;
  for (long i = integer(random, 5, 60); i > 0; --i)
    mesh = joined(mesh, lattice_tetrahedron(random, 0, values - 1));
  return mesh;
}

Mesh lattice_sphere(std::uint64_t seed, Scalar) {
  Random random(seed);
  const long values = integer(random, 2, 6);
  Mesh mesh = icosphere(random.below(3) == 0 ? 2 : 1);
  for (Vec3& p : mesh.positions) p = lattice_point(random, 0, values - 1);
  return mesh;
}

Mesh spikes(std::uint64_t seed, Scalar type) {
  Random random(seed);
  Mesh mesh = two_balls(random, 1);
  for (long i = integer(random, 2, 12); i > 0; --i)
    mesh.positions[random.below(mesh.positions.size())] *=
        std::pow(10, random.uniform(0, largest_exponent(type) / 8));
  return mesh;
}

Mesh denormals(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const double least = type == Scalar::float32 ? 0x1p-149 : 0x1p-1074;
  Mesh mesh = two_balls(random, 1);
  const double size = std::pow(2, random.uniform(2, 30));
  for (Vec3& p : mesh.positions)
    for (double& x : p) x = std::round(x * size) * least;
  return mesh;
}

Mesh near_copies(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const Mesh shape = rotated(icosphere(random.below(2) == 0 ? 0 : 1), any_rotation(random));
  Mesh mesh;
  const auto copies = integer(random, 2, shape.faces.size() > 20 ? 8 : 30);
  for (long i = 0; i < copies; ++i) {
    Mesh copy = shape;
    for (Vec3& p : copy.positions) p += epsilon_of(type) * lattice_point(random, -2, 2);
    mesh = joined(mesh, copy);
  }
  return mesh;
}

Mesh exact_copies(std::uint64_t seed, Scalar) {
  Random random(seed);
  const Mesh shape = any_tetrahedron(random.point(-1, 1), random.point(-1, 1), random.point(-1, 1),
                                     random.point(-1, 1));
  Mesh mesh = icosphere(0);
  for (long i = integer(random, 5, 150); i > 0; --i) mesh = joined(mesh, shape);
  return mesh;
}

Mesh far_from_origin(std::uint64_t seed, Scalar type) {
  Random random(seed);
  const double digits = type == Scalar::float32 ? 8 : 17;
  const Vec3 away = std::pow(10, random.uniform(2, digits)) * random.point(-1, 1);
  return moved(scaled(two_balls(random, 1), std::pow(10, random.uniform(0, 2))), away);
}

Mesh random_sphere(std::uint64_t seed, Scalar) {
  Random random(seed);
  Mesh mesh = icosphere(random.below(3) == 0 ? 2 : 1);
  for (Vec3& p : mesh.positions) p = random.point(-1, 1);
  return mesh;
}

}  // namespace

const std::vector<HostileFamily>& hostile_families() {
  static const std::vector<HostileFamily> families = {
      {"near-vertices", near_vertices},
      {"spike", spike},
      {"far-coordinates", far_coordinates},
      {"plates-on-line", plates_on_line},
      {"nearly-flat", nearly_flat},
      {"stacked-plates", stacked_plates},
      {"needles-in-ball", needles_in_ball},
      {"tetrahedra-at-apex", tetrahedra_at_apex},
      {"tetrahedra-at-edge", tetrahedra_at_edge},
      {"all-magnitudes", all_magnitudes},
      {"some-magnitudes", some_magnitudes},
      {"tetrahedra-of-magnitudes", tetrahedra_of_magnitudes},
      {"tilted-plates", tilted_plates},
      {"sliver-fan", sliver_fan},
      {"lattice-tetrahedra", lattice_tetrahedra},
      {"lattice-sphere", lattice_sphere},
      {"spikes", spikes},
      {"denormals", denormals},
      {"near-copies", near_copies},
      {"exact-copies", exact_copies},
      {"far-from-origin", far_from_origin},
      {"random-sphere", random_sphere}};
  return families;
}

Mesh hostile_mesh(const HostileFamily& family, std::uint64_t seed, Scalar type) {
  Mesh mesh = family.make(seed, type);
  if (type == Scalar::float32)
    for (Vec3& p : mesh.positions)
      for (double& x : p) x = round_to_single(x);
  return mesh;
}

}  // namespace transformesh::corpus
