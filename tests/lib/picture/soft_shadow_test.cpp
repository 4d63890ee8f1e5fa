#include "picture/soft_shadow.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "picture/shade.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// A plate at height 1 with a straight end above x = 0; it covers the side of negative x.
Mesh plate() {
  Mesh mesh;
  mesh.positions = {{-2, -2, 1}, {0, -2, 1}, {0, 2, 1}, {-2, 2, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace

TEST_CASE("below the edge of a plate the visible part of the lamp is a segment of its disc") {
  const SoftShadow shadow(plate(), Vec3::UnitZ());
  const double radius = std::tan(4 * std::numbers::pi / 180);
  for (double share = -1.5; share <= 1.5; share += 0.125) {
    // The end of the plate hides the lamp to the left of the place `across`, measured from the
    // middle of the disc.
    const double across = std::clamp(-share, -1.0, 1.0);
    const double seen =
        (std::acos(across) - across * std::sqrt(1 - across * across)) / std::numbers::pi;
    CHECK(std::abs(shadow.share_seen({share * radius, 0, 0}, Vec3::UnitZ()) - seen) < 0.05);
  }
}

TEST_CASE("a lamp off the center casts the shadow to the side") {
  const Vec3 direction = Vec3(1, 0, 1).normalized();
  const SoftShadow shadow(plate(), direction);
  CHECK(shadow.share_seen({-1.3, 0, 0}, Vec3::UnitZ()) == 0);
  CHECK(shadow.share_seen({-0.7, 0, 0}, Vec3::UnitZ()) == 1);
}

TEST_CASE("the lit side of a convex body has no shadow, round or flat") {
  const Vec3 direction = Vec3(1, 2, 3).normalized();
  for (const Mesh& mesh : {icosphere(1), icosphere(4), cuboid({0, 0, 0}, {1, 2, 3})}) {
    const SoftShadow shadow(mesh, direction);
    for (const auto& [a, b, c] : mesh.faces) {
      const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
      const Vec3 normal = (q - p).cross(r - p).normalized();
      const float share = shadow.share_seen(0.2 * p + 0.3 * q + 0.5 * r, normal);
      if (normal.dot(direction) > 0.1) CHECK(share == 1);
      // Lifted points are lit slightly beyond the horizon, where the light does not reach the
      // surface.
      if (normal.dot(direction) < -0.3) CHECK(share == 0);
    }
  }
}

TEST_CASE("points on coarse faces are moved to the surface that their normals suggest") {
  const std::array<Vec3, 3> corners{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const Vec3 place = round_place(corners, corners, 1.0 / 3, 1.0 / 3);
  CHECK(place.norm() > 0.95);
  CHECK(place.norm() < 1.15);
  CHECK(round_place(corners, corners, 1, 0).isApprox(corners[0]));
  const std::array<Vec3, 3> hollow{-corners[0], -corners[1], -corners[2]};
  CHECK(round_place(corners, hollow, 0.25, 0.25).isApprox(Vec3(0.25, 0.25, 0.5)));
}

TEST_CASE("the floor is dark where the mesh hides the lamp, and nowhere else") {
  const Mesh ball = icosphere(3);
  const Orbit orbit{0, 30, Axis::y, 0.4};
  const Camera camera = orbit_camera(aim_at(ball.positions, orbit, 120, 120), orbit, 120, 120);
  ShadeOptions options;
  options.background.is_transparent = true;
  const Image plain = shade(ball, camera, options);
  options.soft_shadow = true;
  CHECK(shade(ball, camera, options).at(0, 0)[3] == 0);
  options.floor = -1;
  const Image shaded = shade(ball, camera, options);
  int right = 0, left = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      if (plain.at(x, y)[3] > 0 || shaded.at(x, y)[3] == 0) continue;
      CHECK(shaded.at(x, y)[0] == 0);
      (x > 60 ? right : left) += 1;
    }
  // The key light comes from the left.
  CHECK(right > 200);
  CHECK(left < right / 4);
  options.floor = 5;
  CHECK(shade(ball, camera, options).at(100, 70)[3] == 0);
}

TEST_CASE("shadows are the same for any number of threads; what is degenerate has none") {
  const Mesh ring = torus(1, 0.4, 40, 24);
  const auto shares = [&](int threads) {
    const ThreadLimit limit(threads);
    const SoftShadow shadow(ring, Vec3(1, 1, 2).normalized());
    std::vector<float> all;
    for (const Vec3& point : ring.positions) all.push_back(shadow.share_seen(point, Vec3::UnitX()));
    return all;
  };
  CHECK(shares(1) == shares(3));
  Mesh point;
  point.positions.assign(3, Vec3(1, 2, 3));
  point.faces = {{0, 1, 2}};
  CHECK(SoftShadow(point, Vec3::UnitX()).share_seen({1, 2, 3}, Vec3::UnitX()) == 1);
  CHECK(SoftShadow({}, Vec3::UnitX()).share_seen({1, 2, 3}, Vec3::UnitX()) == 1);
}
