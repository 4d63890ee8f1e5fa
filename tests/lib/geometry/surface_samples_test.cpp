#include "geometry/surface_samples.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "helpers/shapes.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("samples lie on the surface, evenly by area however it is cut") {
  // A cube with one side cut finely, and with faces without area.
  Mesh mesh = test::joined(test::cube(), test::grid(20));
  mesh.faces.erase(mesh.faces.begin(), mesh.faces.begin() + 2);  // the side z = 0 of the cube
  mesh.faces.push_back({0, 0, 1});
  const std::size_t count = 60000;
  const auto points = surface_samples(mesh, count, 3);
  REQUIRE(points.size() == count);

  std::array<double, 6> on_side{};
  std::array<double, 8> in_eighth{};
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) {
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side)
        if (std::abs(point[axis] - side) < 1e-15) {
          ++on_side[static_cast<std::size_t>(2 * axis + side)];
          ++sides;
        }
    CHECK(sides == 1);
    CHECK(point.minCoeff() >= -1e-15);
    CHECK(point.maxCoeff() <= 1 + 1e-15);
    if (std::abs(point.z()) < 1e-15) ++in_eighth[static_cast<std::size_t>(8 * point.x())];
    mean += point / count;
  }
  for (const double share : on_side) CHECK(share / count == Approx(1.0 / 6).epsilon(0.01));
  for (const double share : in_eighth) CHECK(share / count == Approx(1.0 / 48).epsilon(0.05));
  CHECK((mean - Vec3(0.5, 0.5, 0.5)).norm() < 0.005);
}

TEST_CASE("samples depend on the seed only") {
  const Mesh mesh = test::icosphere(2);
  CHECK(surface_samples(mesh, 100, 1) == surface_samples(mesh, 100, 1));
  CHECK(surface_samples(mesh, 100, 1) != surface_samples(mesh, 100, 2));
}

TEST_CASE("no area, no samples") {
  CHECK(surface_samples(Mesh{}, 100, 1).empty());
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.faces = {{0, 1, 2}};
  CHECK(surface_samples(flat, 100, 1).empty());
  CHECK(surface_samples(test::cube(), 0, 1).empty());
}
