/// Flat openings with several border loops, compared with the areas and bodies of which they are
/// part.
#include "fill/flat_openings.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "helpers/shapes.h"
#include "transformesh/fill.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
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
  return group_flat_openings(mesh,
                             join_touching_holes(mesh, check_manifold(mesh).border_halfedges));
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

}  // namespace transformesh
