/// Flat openings with several border loops, compared with the areas and bodies of which they are
/// part.
#include "fill/openings.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/fill.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

/// Returns the walls of a box without top and bottom. With `is_inward`, they are oriented inwards.
Mesh walls(const Vec3& low, const Vec3& high, bool is_inward) {
  Mesh mesh = test::cuboid(low, high);
  mesh.faces.erase(mesh.faces.begin(), mesh.faces.begin() + 4);
  return is_inward ? test::reversed(mesh) : mesh;
}

/// Returns a plate with two rectangular holes, without top and bottom.
Mesh plate() {
  const Mesh first = walls({1, 1, 0}, {3, 4, 1}, true), second = walls({5, 2, 0}, {6, 3, 1}, true);
  return test::joined(walls({0, 0, 0}, {8, 5, 1}, false), test::joined(first, second));
}

Mesh rotated(Mesh mesh, double scale) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : mesh.positions) p = scale * (turn * p);
  return mesh;
}

std::vector<std::vector<HoleLoop>> groups_of(Mesh mesh) {
  return group_openings(mesh, join_touching_holes(mesh, check_manifold(mesh).border_halfedges));
}

}  // namespace

TEST_CASE("both sides of a plate with holes are one opening each, in any position") {
  for (const double scale : {1e-150, 1.0, 1e150}) {
    const Mesh mesh = rotated(plate(), scale);
    const auto groups = groups_of(mesh);
    REQUIRE(groups.size() == 2);
    for (const std::vector<HoleLoop>& group : groups) {
      REQUIRE(group.size() == 3);
      double area = 0;
      const std::vector<Face> faces = triangulate_opening(mesh, group);
      CHECK(faces.size() == 14);
      for (const auto& [a, b, c] : faces) {
        const Vec3 u = (mesh.positions[b] - mesh.positions[a]) / scale;
        area += u.cross((mesh.positions[c] - mesh.positions[a]) / scale).norm() / 2;
      }
      CHECK(area == doctest::Approx(40 - 6 - 1));
    }
  }
}

TEST_CASE("a plate with holes, without top and bottom, becomes the plate") {
  for (const FillOptions& options : {FillOptions{.refine = false}, FillOptions{.fair = false}}) {
    Mesh mesh = rotated(plate(), 1);
    const FillResult result = fill_holes(mesh, options);
    CHECK(result.holes == 2);
    CHECK(result.filled() == 2);
    CHECK(check_manifold(mesh).is_manifold());
    CHECK(check_manifold(mesh).is_closed());
    CHECK(find_intersections(mesh).empty());
    CHECK(volume(mesh) == doctest::Approx(33));
  }
  // A small loop is no hole of its own.
  Mesh mesh = plate();
  const FillResult result = fill_holes(mesh, {.max_diameter = 2});
  CHECK(result.filled() == 0);
  REQUIRE(result.too_large.size() == 2);
  CHECK(result.too_large[0].edges == 12);
}

TEST_CASE("an opening may touch faces within it at vertices") {
  // Four squares of the missing bottom are left; three of them touch walls or each other.
  Mesh mesh;
  const Index n = 6;
  for (Index z = 0; z <= 1; ++z)
    for (Index y = 0; y <= n; ++y)
      for (Index x = 0; x <= n; ++x) mesh.positions.emplace_back(x, y, z);
  const auto at = [](Index x, Index y, Index z) { return (z * (n + 1) + y) * (n + 1) + x; };
  const auto add = [&](Index a, Index b, Index c, Index d) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  };
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      add(at(x, y, 1), at(x + 1, y, 1), at(x + 1, y + 1, 1), at(x, y + 1, 1));
      if ((x == 1 || x == 2 || x == 4) && y == x)
        add(at(x, y, 0), at(x, y + 1, 0), at(x + 1, y + 1, 0), at(x + 1, y, 0));
    }
  add(at(4, 1, 0), at(4, 2, 0), at(5, 2, 0), at(5, 1, 0));
  mesh.faces.push_back({at(0, 3, 0), at(1, 4, 0), at(1, 3, 0)});
  for (Index k = 0; k < n; ++k) {
    add(at(k, 0, 0), at(k + 1, 0, 0), at(k + 1, 0, 1), at(k, 0, 1));
    add(at(n, k, 0), at(n, k + 1, 0), at(n, k + 1, 1), at(n, k, 1));
    add(at(k + 1, n, 0), at(k, n, 0), at(k, n, 1), at(k + 1, n, 1));
    add(at(0, k + 1, 0), at(0, k, 0), at(0, k, 1), at(0, k + 1, 1));
  }
  for (const bool are_copies : {false, true})
    for (const FillOptions& options : {FillOptions{.refine = false}, FillOptions{.fair = false}}) {
      CAPTURE(are_copies);
      Mesh filled = rotated(mesh, 1);
      // Gives each body that touches another one its own copy of the vertex.
      if (are_copies) stitch(filled);
      CHECK(check_manifold(filled).nonmanifold_vertices.empty() == are_copies);
      CHECK(fill_holes(filled, options).filled() == 1);
      CHECK(check_manifold(filled).is_manifold());
      CHECK(check_manifold(filled).is_closed());
      CHECK(find_intersections(filled).empty());
      CHECK(volume(filled) == doctest::Approx(36));
    }
}

TEST_CASE("an island below a corner of the rim leaves no border unreported") {
  // In the plane of the opening, a corner of the island coincides with a corner of the rim.
  for (int corner = 0; corner < 4; ++corner) {
    CAPTURE(corner);
    Mesh mesh = walls({-2, -2, 0}, {2, 2, 4}, true);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const auto& [x, y] : {std::pair(-2, -2), std::pair(0, -1), std::pair(-1, 0)}) {
      const std::array turned{Vec3(x, y, -0.5), Vec3(-y, x, -0.5), Vec3(-x, -y, -0.5),
                              Vec3(y, -x, -0.5)};
      mesh.positions.push_back(turned.at(static_cast<std::size_t>(corner)));
    }
    mesh.faces.push_back({first, first + 1, first + 2});
    const FillResult result = fill_holes(mesh, {.fair = false});
    CHECK(check_manifold(mesh).is_closed() == (result.filled() == result.holes));
  }
}

TEST_CASE("an island in a hole of a ball is joined by one smooth patch") {
  const Mesh ball = test::icosphere(4);
  const auto height = [&](const Face& face) {
    const auto& [a, b, c] = face;
    return (ball.positions[a] + ball.positions[b] + ball.positions[c]).normalized().z();
  };
  for (const auto& [low, high] : {std::pair(0.75, 0.95), std::pair(0.9, 0.995)}) {
    CAPTURE(low);
    Mesh mesh = ball;
    std::erase_if(mesh.faces,
                  [&](const Face& face) { return height(face) > low && height(face) < high; });
    mesh = rotated(mesh, 1);
    CHECK(groups_of(mesh).size() == 1);
    const FillResult result = fill_holes(mesh);
    CHECK(result.holes == 1);
    CHECK(result.faired == 1);
    CHECK(check_manifold(mesh).is_manifold());
    CHECK(check_manifold(mesh).is_closed());
    CHECK(find_intersections(mesh).empty());
    CHECK(test::signed_volume(mesh) == doctest::Approx(test::signed_volume(ball)).epsilon(1e-3));
  }
}

TEST_CASE("the direction of a flat rim does not matter for an island above it") {
  // Rings of a ball around (1, 1, 1), each 10 degrees wide; those from 20 to 60 degrees are
  // missing.
  const Vec3 axis = Vec3::Ones().normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
  constexpr int sides = 24;
  Mesh mesh;
  for (int ring = 0; ring <= 18; ++ring)
    for (int k = 0; k < (ring % 18 == 0 ? 1 : sides); ++k) {
      const double polar = ring * std::numbers::pi / 18, turn = 2 * std::numbers::pi * k / sides;
      mesh.positions.push_back(std::cos(polar) * axis +
                               std::sin(polar) * (std::cos(turn) * u + std::sin(turn) * v));
    }
  const auto at = [](int ring, int k) {
    return ring == 0    ? Index{0}
           : ring == 18 ? Index{1 + 17 * sides}
                        : static_cast<Index>(1 + (ring - 1) * sides + k % sides);
  };
  for (int ring = 0; ring < 18; ++ring)
    for (int k = 0; k < sides && (ring < 2 || ring >= 6); ++k) {
      if (ring < 17) mesh.faces.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
      if (ring > 0) mesh.faces.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
  CHECK(groups_of(mesh).size() == 1);
  CHECK(fill_holes(mesh).faired == 1);
  CHECK(check_manifold(mesh).is_closed());
  CHECK(test::signed_volume(mesh) == doctest::Approx(4.189).epsilon(0.03));
}

TEST_CASE("walls whose rim is near a larger opening are no island, in any direction") {
  const Mesh tube = walls({0, 0, 0}, {4, 4, 1}, false);
  test::Random random(7);
  for (const double height : {0.8, 1.0, 1.2}) {
    Mesh mesh = test::joined(tube, walls({1, 1, height}, {2, 2, 3}, false));
    for (int k = 0; k < 40; ++k) {
      const Eigen::AngleAxisd turn(1, random.point(-1, 1).normalized());
      for (Vec3& p : mesh.positions) p = turn * p;
      CHECK(groups_of(mesh).size() == (height == 1 ? 3 : 4));
    }
  }
}

TEST_CASE("an island that touches the rim of a curved hole at a vertex does not become a body") {
  // One of the cells that are left in the hole shares a vertex with the rim.
  Mesh mesh = test::grid(9);
  for (Vec3& p : mesh.positions)
    p.z() = 2 - 2 * (p.head<2>() - Eigen::Vector2d(0.5, 0.5)).squaredNorm();
  std::erase_if(mesh.faces, [&](const Face& face) {
    const auto& [a, b, c] = face;
    const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    const int x = static_cast<int>(9 * middle.x()), y = static_cast<int>(9 * middle.y());
    const bool is_kept = (x == 4 && y == 4) || (x == 2 && y == 2);
    return std::max(std::abs(x - 4), std::abs(y - 4)) <= 2 && !is_kept;
  });
  CHECK(groups_of(mesh).size() == 2);
  const FillResult result = fill_holes(mesh, {.max_edges = 30});
  CHECK(result.filled() == 1);
  CHECK(check_manifold(mesh).boundary_loops == 1);
  CHECK(find_intersections(mesh).empty());
}

TEST_CASE("rounded coordinates far from the origin do not separate the loops of an opening") {
  Mesh mesh = rotated(plate(), 1);
  for (Vec3& p : mesh.positions) p = (p + Vec3(1e5, 5e4, 2e4)).cast<float>().cast<double>();
  CHECK(groups_of(mesh).size() == 2);
  CHECK(fill_holes(mesh, {.fair = false}).filled() == 2);
  CHECK(check_manifold(mesh).is_closed());
}

TEST_CASE("loops with the same direction, beside each other or in other planes, are alone") {
  const Mesh outer = walls({0, 0, 0}, {4, 4, 4}, false);
  CHECK(groups_of(test::joined(outer, walls({1, 1, 0}, {2, 2, 4}, false))).size() == 4);
  CHECK(groups_of(test::joined(outer, walls({5, 1, 0}, {6, 2, 4}, true))).size() == 4);
  CHECK(groups_of(test::joined(outer, walls({1, 1, 1}, {2, 2, 3}, true))).size() == 4);
  CHECK(groups_of(test::joined(outer, walls({1, 1, 0}, {2, 2, 4}, true))).size() == 2);
}
