#include "shapes/lattice.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/mesh_facts.h"

using namespace transformesh;
using namespace transformesh::test;
using shapes::ImplicitSolid;

namespace {

ImplicitSolid ball() {
  ImplicitSolid solid;
  solid.function = [](const Vec3& p) { return p.norm() - 1; };
  return solid;
}

ImplicitSolid ring() {
  ImplicitSolid solid;
  solid.function = [](const Vec3& p) { return std::hypot(p.head<2>().norm() - 0.7, p.z()) - 0.3; };
  return solid;
}

}  // namespace

TEST_CASE("every placement of the lattice gives a closed manifold of the solid's genus") {
  for (unsigned variant = 0; variant < 6; ++variant) {
    CAPTURE(variant);
    for (const auto& [solid, genus] : {std::pair{ball(), 0L}, std::pair{ring(), 1L}}) {
      const Count counted = count(shapes::march(solid, 0.06, variant));
      CHECK(counted.is_closed_and_oriented);
      CHECK(counted.is_manifold);
      CHECK_FALSE(counted.has_isolated_vertices);
      CHECK(counted.genera == std::vector<long>{genus});
    }
  }
  CHECK(shapes::march(ball(), 0.06, 0).positions != shapes::march(ball(), 0.06, 1).positions);
}

TEST_CASE("volumes approach those of ball and torus as the square of the spacing") {
  const double pi = std::numbers::pi;
  const auto error = [](const ImplicitSolid& solid, double spacing, double volume) {
    return std::abs(signed_volume(shapes::march(solid, spacing, 2)) / volume - 1);
  };
  for (const auto& [solid, volume] :
       {std::pair{ball(), 4 * pi / 3}, std::pair{ring(), 2 * pi * pi * 0.7 * 0.09}}) {
    CHECK(error(solid, 0.06, volume) < 0.02);
    CHECK(error(solid, 0.03, volume) < 0.35 * error(solid, 0.06, volume));
  }
}

TEST_CASE("points close to the surface have moved onto it: no triangle is a sliver") {
  const Mesh mesh = shapes::march(ball(), 0.05, 1);
  double least = 180;
  for (const auto& [a, b, c] : mesh.faces) {
    const std::array<Vec3, 3> p{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 u = p[(i + 1) % 3] - p[i];
      const Vec3 v = p[(i + 2) % 3] - p[i];
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi);
    }
  }
  CHECK(least > 5);
}
