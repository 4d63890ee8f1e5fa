#include "remesh/operations/exact_split.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/cgal_oracle.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "remesh/operations/split.h"
#include "transformesh/intersect.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Two tetrahedra on either side of an edge, each with its own copy of the edge. The midpoint of
/// the edge is not representable.
Mesh tetrahedra_at_an_edge() {
  const Vec3 a(0.1, 0.2, 0.3), b(0.7, 1.1, 1.3);
  Mesh first;
  first.positions = {a, b, {2, 0, 0}, {2, 0, 1}};
  first.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  Mesh second;
  second.positions = {a, b, {-2, 1, 0}, {-2, 1, 1}};
  second.faces = first.faces;
  return joined(first, second);
}

}  // namespace

TEST_CASE("copies of an edge are split together, at one place") {
  Mesh mesh = tetrahedra_at_an_edge();
  EditableMesh editable(mesh);
  ExactGuard guard(editable);
  ExactSplitter splitter(editable, guard);
  Index edge = no_index;
  for (Index h = 0; h < editable.halfedge_slots() && edge == no_index; ++h)
    if (editable.source(h) == 0 && editable.target(h) == 1) edge = h;
  REQUIRE(edge != no_index);
  const std::vector<Index> vertices = splitter.split(edge, false);
  REQUIRE(vertices.size() == 2);
  CHECK(editable.position(vertices[0]) == editable.position(vertices[1]));
  const Mesh result = editable.to_mesh();
  CHECK(is_closed(result));
  CHECK(is_oriented_manifold(result));
  CHECK(find_intersections(result).empty());
}

TEST_CASE("sheets one spacing apart are split without touching each other") {
  // Two parallel sheets, oblique to the axes, the second one spacing above the first in z.
  Mesh lower = grid(1);
  for (Vec3& p : lower.positions) p = {p.x() + 0.3, p.y() + 0.7, 0.37 * p.x() + 0.23 * p.y() + 1};
  Mesh upper = lower;
  for (Vec3& p : upper.positions) p.z() = std::nextafter(p.z(), 4);
  EditableMesh editable(joined(lower, upper));
  REQUIRE(find_intersections(editable.to_mesh()).empty());
  const SplitCounts counts = split_long_edges_exactly(editable, {0.05, false}, {});
  CHECK(counts.done > 100);
  CHECK(find_intersections(editable.to_mesh()).empty());
  CHECK(count_self_intersections(editable.to_mesh()) == 0);
}

TEST_CASE("intersections of the input are split like everything else") {
  Mesh second = cube();
  for (Vec3& p : second.positions) p += Vec3(0.31, 0.37, 0.41);
  EditableMesh editable(joined(cube(), second));
  const std::size_t before = find_intersections(editable.to_mesh()).size();
  REQUIRE(before > 0);
  CHECK(split_long_edges_exactly(editable, {0.2, false}, {}).refused == 0);
}
