#include "transformesh/velocity.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "helpers/shapes.h"
#include "transformesh/shapes.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("curvature flow shrinks a sphere by the inverse of its radius") {
  for (const double radius : {0.5, 2.0}) {
    const Mesh sphere = make_sphere(Vec3(1, 2, 3), radius, 5000);
    const std::vector<Vec3> velocities = curvature_velocities(sphere, 3);
    for (std::size_t v = 0; v < velocities.size(); ++v) {
      const Vec3 inwards = (Vec3(1, 2, 3) - sphere.positions[v]) / radius;
      CHECK(velocities[v].dot(inwards) == Approx(3 / radius).epsilon(0.03));
      CHECK((velocities[v] - velocities[v].dot(inwards) * inwards).norm() < 0.1 / radius);
    }
  }
}

TEST_CASE("on a torus the curvature flow is that of the closed form") {
  ShapeOptions options;
  options.kind = "torus";
  options.radius = 1;
  options.tube = 0.35;
  options.faces = 20000;
  const Mesh torus = make_shape(options);
  const std::vector<Vec3> velocities = curvature_velocities(torus, 1);
  double worst = 0;
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    const Vec3& p = torus.positions[v];
    const double ring = std::hypot(p.x(), p.y());
    const Vec3 normal = (p - Vec3(p.x() / ring, p.y() / ring, 0)) / 0.35;
    // The principal curvatures are 1 / tube and cos / ring. The cosine is that of the angle around
    // the tube, and `ring` is the distance from the axis.
    const double mean_curvature = (1 / 0.35 + (ring - 1) / 0.35 / ring) / 2;
    worst = std::max(worst, (velocities[v] + mean_curvature * normal).norm() / mean_curvature);
  }
  CHECK(worst < 0.05);
}

TEST_CASE("planes, borders and slivers are stable under curvature flow") {
  Mesh plane;
  for (int i = 0; i < 9; ++i) plane.positions.emplace_back(i % 3, i / 3, 0);
  plane.faces = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4},
                 {3, 4, 6}, {4, 7, 6}, {4, 5, 7}, {5, 8, 7}};
  for (const Vec3& velocity : curvature_velocities(plane, 1)) CHECK(velocity.norm() < 1e-12);
  // A sphere with many pairs of nearly coincident vertices, which make slivers everywhere.
  Mesh slivers = test::icosphere(3);
  for (std::size_t v = 1; v < slivers.positions.size(); v += 7)
    slivers.positions[v] = slivers.positions[slivers.faces[v][0]] * (1 + 1e-9);
  for (const Vec3& velocity : curvature_velocities(slivers, 1)) CHECK(velocity.allFinite());
}

TEST_CASE("mean curvature is that of the closed forms, with the sign of the side") {
  Mesh sphere = make_sphere(Vec3(1, 2, 3), 2, 5000);
  for (const double curvature : mean_curvatures(sphere))
    CHECK(curvature == Approx(0.5).epsilon(0.03));
  for (Face& face : sphere.faces) std::swap(face[1], face[2]);
  for (const double curvature : mean_curvatures(sphere))
    CHECK(curvature == Approx(-0.5).epsilon(0.03));

  // The mean curvature of a thick torus has both signs. The principal curvatures are 1 / tube and
  // cos / radius. The cosine is that of the angle around the tube.
  const double tube = 0.7;
  const Mesh ring = test::torus(1, tube, 200, 150);
  const std::vector<double> curvatures = mean_curvatures(ring);
  int negative = 0;
  for (std::size_t v = 0; v < curvatures.size(); ++v) {
    const double radius = std::hypot(ring.positions[v].x(), ring.positions[v].y());
    const double expected = (1 / tube + (radius - 1) / tube / radius) / 2;
    CHECK(std::abs(curvatures[v] - expected) < 0.02);
    negative += curvatures[v] < 0;
  }
  CHECK(negative > 1000);
}

TEST_CASE("mean curvature is 0 on borders and planes, and if it overflows") {
  for (const double curvature : mean_curvatures(test::grid(5))) CHECK(std::abs(curvature) < 1e-12);
  for (const double size : {1e-300, 1e-160, 1e200, 1e300})
    for (const double curvature : mean_curvatures(test::scaled(test::cube(), size)))
      CHECK(std::isfinite(curvature));
}
TEST_CASE("velocities are the sum of the given ones and of the speeds, times the mask") {
  Mesh mesh = test::icosphere(3);
  const std::size_t count = mesh.positions.size();
  VelocityOptions options;
  options.normal_speed = 2;
  options.given.emplace(count, Vec3(1, 0, 0));
  options.mask = std::string("weight");
  Column& mask = mesh.vertex_columns.get("weight", Scalar::float64, count);
  mask.values.assign(count, 3);
  const std::vector<Vec3> velocities = velocities_of(mesh, options);
  for (std::size_t v = 0; v < count; ++v)
    CHECK((velocities[v] - 3 * (Vec3(1, 0, 0) + 2 * mesh.positions[v])).norm() < .1);
}

TEST_CASE("columns are used if no velocities are given, and missing velocities refused") {
  Mesh mesh = test::icosphere(1);
  try {
    velocities_of(mesh, {});
    FAIL("nothing moves the mesh");
  } catch (const InputError& error) {
    CHECK(error.kind() == ErrorKind::no_velocity);
  }
  for (const char* name : {"vx", "vy", "vz"})
    mesh.vertex_columns.get(name, Scalar::float64, mesh.positions.size()).values[5] = 4;
  CHECK(velocities_of(mesh, {})[5] == Vec3(4, 4, 4));
  VelocityOptions given;
  given.given.emplace(mesh.positions.size(), Vec3(1, 2, 3));
  CHECK(velocities_of(mesh, given)[5] == Vec3(1, 2, 3));
}

TEST_CASE("a velocity without one of its coordinates is refused, even if a speed is given") {
  for (const std::string missing : {"vx", "vy", "vz"}) {
    Mesh mesh = test::icosphere(1);
    for (const std::string name : {"vx", "vy", "vz"})
      if (name != missing) mesh.vertex_columns.get(name, Scalar::float64, mesh.positions.size());
    VelocityOptions options;
    options.normal_speed = 1;
    CHECK_THROWS_AS(velocities_of(mesh, options), InputError);
  }
}

TEST_CASE("a wrong number of velocities is refused before any is added") {
  const Mesh mesh = test::icosphere(1);
  for (const std::size_t count :
       {std::size_t{0}, mesh.positions.size() - 1, mesh.positions.size() + 9}) {
    VelocityOptions options;
    options.given.emplace(count, Vec3(1, 0, 0));
    options.normal_speed = 1;
    CHECK_THROWS_AS(velocities_of(mesh, options), UsageError);
  }
}
