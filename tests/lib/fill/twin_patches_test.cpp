// A torus cut through along a loop around its tube, and closed on both sides.
#include "fill/twin_patches.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"
#include "transformesh/components.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

constexpr int around = 24, across = 10;

struct Cut {
  Mesh mesh = test::torus(2, .5, around, across);
  HalfedgeStars stars{mesh, opposite_halfedges(mesh)};
  std::vector<Index> loop;
  SlitSides sides;

  Cut() {
    for (Index j = 0; j < across; ++j) loop.push_back(j);
    sides = sides_of(mesh, loop, stars);
  }
};

}  // namespace

TEST_CASE("a patch of the loop around a tube has its area, and no edge that a side has") {
  const Cut cut;
  const auto patch = patch_of_slit(cut.mesh, cut.loop, cut.sides, cut.stars);
  REQUIRE(patch);
  Mesh surface = cut.mesh;
  surface.positions.insert(surface.positions.end(), patch->points.begin(), patch->points.end());
  surface.faces = patch->faces;
  const double radius = .5;
  // The loop is a regular decagon.
  const double area = across / 2.0 * radius * radius * std::sin(2 * std::numbers::pi / across);
  CHECK(surface_area(surface) == doctest::Approx(area).epsilon(.02));
}

TEST_CASE("closing the slit makes a sphere of the torus, with new faces behind the old ones") {
  Cut cut;
  const auto patch = patch_of_slit(cut.mesh, cut.loop, cut.sides, cut.stars);
  REQUIRE(patch);
  const ClosedSlit slit = drawn_apart(cut.mesh, cut.loop, cut.sides, *patch, Scalar::float64);
  CHECK(slit.left_patch().size() == slit.faces.size());
  CHECK(slit.right_patch().size() == slit.faces.size());
  Mesh closed = cut.mesh;
  close_slit(closed, cut.loop, cut.sides, *patch, slit);
  CHECK(closed.faces.size() == cut.mesh.faces.size() + 2 * slit.faces.size());
  const ManifoldReport report = check_manifold(closed);
  CHECK(report.is_manifold());
  CHECK(report.is_oriented());
  CHECK(report.is_closed());
  CHECK(connected_components(closed).genus() == 0);
  CHECK(connected_components(closed).components.size() == 1);
  CHECK(find_intersections(closed).empty());
  CHECK(volume(closed) < volume(cut.mesh));
  CHECK(volume(closed) > volume(cut.mesh) * .9);
}

TEST_CASE("sides are moved apart by a third of the distance to their neighbors") {
  const Cut cut;
  for (std::size_t i = 0; i < cut.loop.size(); ++i) {
    const Vec3& at = cut.mesh.positions[cut.loop[i]];
    const Vec3 left = cut.sides.left.drawn_back[i] - at, right = cut.sides.right.drawn_back[i] - at;
    CHECK(left.dot(right) < 0);
    CHECK(left.norm() == doctest::Approx(right.norm()).epsilon(.5));
  }
}
