#include "fill/hole_patch.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/edges.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

struct Hole {
  Mesh mesh;
  Index halfedge;
};

Hole hole_in(Mesh mesh, std::size_t faces) {
  mesh.faces.resize(mesh.faces.size() - faces);
  const Index halfedge = check_manifold(mesh).border_halfedges.front();
  return {std::move(mesh), halfedge};
}

Mesh patched(const Hole& hole, const HolePatch& patch) {
  Mesh mesh = hole.mesh;
  mesh.positions.insert(mesh.positions.end(), patch.points.begin(), patch.points.end());
  mesh.faces.insert(mesh.faces.end(), patch.faces.begin(), patch.faces.end());
  return mesh;
}

void check_closed(const Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.is_closed());
  CHECK(report.is_manifold());
  CHECK(report.is_oriented());
}

}  // namespace

TEST_CASE("the missing side of a cube is filled by two triangles in its plane") {
  const Hole hole = hole_in(test::cube(), 2);  // the side x = 1
  for (const Search search : {Search::all, Search::delaunay}) {
    const HolePatches found = patch_hole(hole.mesh, hole.halfedge, PatchKind::plain, search);
    REQUIRE(found.patches.size() == 1);
    CHECK(found.patches[0].kind == PatchKind::plain);
    CHECK(found.patches[0].faces.size() == 2);
    const Mesh mesh = patched(hole, found.patches[0]);
    check_closed(mesh);
    CHECK(volume(mesh) == doctest::Approx(1));
  }
}

TEST_CASE("patches come with the finest first, and each closes the hole") {
  const Hole hole = hole_in(test::icosphere(3), 64);
  const HolePatches found = patch_hole(hole.mesh, hole.halfedge, PatchKind::faired, Search::all);
  REQUIRE(found.patches.size() >= 2);
  CHECK(found.patches.front().kind == PatchKind::faired);
  CHECK(found.patches.back().kind == PatchKind::plain);
  CHECK(found.patches.back().points.empty());
  for (const HolePatch& patch : found.patches) check_closed(patched(hole, patch));
}

TEST_CASE("a faired patch continues a sphere better than a plain one") {
  const Hole hole = hole_in(test::icosphere(3), 64);
  const HolePatches found = patch_hole(hole.mesh, hole.halfedge, PatchKind::faired, Search::all);
  const double whole = volume(test::icosphere(3));
  const double faired = volume(patched(hole, found.patches.front()));
  const double plain = volume(patched(hole, found.patches.back()));
  CHECK(std::abs(faired - whole) < std::abs(plain - whole) / 3);
  for (const Vec3& point : found.patches.front().points)
    CHECK(point.norm() == doctest::Approx(1).epsilon(.03));
}
