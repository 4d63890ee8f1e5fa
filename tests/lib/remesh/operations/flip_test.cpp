#include "remesh/operations/flip.h"

#include <algorithm>

#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "remesh/guards/edge_rules.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr EdgeLimits any_length{0, 1e3};

/// Two triangles over the edge from (-2, 0, 0) to (2, 0, 0), with the other corners at y = 1 and
/// -1, below the edge by `depth`. The other diagonal makes larger angles.
Mesh kite(double depth = 0) {
  Mesh mesh;
  mesh.positions = {{-2, 0, 0}, {2, 0, 0}, {0, 1, -depth}, {0, -1, -depth}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}};
  return mesh;
}

/// A tetrahedron about a hundredth wide that extends from z = low to z = high along the z axis.
Mesh needle(double low, double high) {
  Mesh mesh;
  mesh.positions = {{0.01, 0, low}, {-0.01, 0.01, low}, {-0.01, -0.01, low}, {0, 0, high}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

bool has_edge(const Mesh& mesh, Index a, Index b) {
  return edge_faces(mesh).count(std::minmax(a, b)) > 0;
}

struct Flipped {
  FlipCounts counts;
  Mesh mesh;
};

Flipped flipped(const Mesh& mesh, FlipRule rule, const EdgeLimits& limits = any_length) {
  EditableMesh editable(mesh);
  EmbeddingGuard guard(editable, limits.stretched());
  const FlipCounts counts = flip_edges(editable, guard, rule, limits, {});
  return {counts, editable.to_mesh()};
}

Index halfedge_of(const EditableMesh& mesh, Index source, Index target) {
  for (Index h = 0; h < mesh.halfedge_slots(); ++h)
    if (mesh.has_halfedge(h) && mesh.source(h) == source && mesh.target(h) == target) return h;
  return no_index;
}

bool flips(const Mesh& mesh, Index source, Index target) {
  EditableMesh editable(mesh);
  EmbeddingGuard guard(editable, 0);
  return flip_edge(editable, guard, halfedge_of(editable, source, target));
}

}  // namespace

TEST_CASE("the diagonal of a kite that makes the larger angles is taken, once") {
  const Flipped result = flipped(kite(), FlipRule::angle);
  CHECK(result.counts.done == 1);
  CHECK(result.counts.refused == 0);
  CHECK(has_edge(result.mesh, 2, 3));
  CHECK_FALSE(has_edge(result.mesh, 0, 1));
  CHECK(flipped(result.mesh, FlipRule::angle).counts.done == 0);
  CHECK(flipped(kite(), FlipRule::none).counts.done == 0);
}

TEST_CASE("in a torus with one flipped edge, only this flip is undone") {
  const Mesh regular = torus(2, 1, 40, 24);
  CHECK(flipped(regular, FlipRule::valence).counts.done == 0);
  for (const Index quad : {0, 77, 500}) {
    EditableMesh mesh(regular);
    const Index diagonal = 6 * quad + 2;
    REQUIRE(mesh.can_flip(diagonal));
    mesh.flip(diagonal);
    EmbeddingGuard guard(mesh, any_length.stretched());
    CHECK(flip_edges(mesh, guard, FlipRule::valence, any_length, {}).done == 1);
    CHECK(edge_faces(mesh.to_mesh()) == edge_faces(regular));
  }
}

TEST_CASE("no flip makes an edge longer than allowed") {
  // In a sheared grid, the diagonals that give valences of six are the longer ones, of 1.72 cells.
  Mesh sheared = grid(8);
  for (Vec3& p : sheared.positions) p = 8 * Vec3(p.x() + 0.4 * p.y(), p.y(), 0);
  const auto flips_back = [&](double longest) {
    EditableMesh mesh(sheared);
    const Index diagonal = 6 * (8 * 3 + 4) + 2;
    mesh.flip(diagonal);
    // All other edges are sharp, so that they stay.
    for (Index h = 0; h < mesh.halfedge_slots(); ++h) mesh.set_feature(h, true);
    mesh.set_feature(diagonal, false);
    const EdgeLimits limits{0, longest / 1.12};
    EmbeddingGuard guard(mesh, limits.stretched());
    return flip_edges(mesh, guard, FlipRule::valence, limits, {}).done == 1;
  };
  CHECK_FALSE(flips_back(1.71));
  CHECK(flips_back(1.73));
}

TEST_CASE("no flip bends the surface, and none takes a border or a sharp edge") {
  // The two faces of a cube's side are coplanar; those at its edges are at right angles.
  const Mesh box = cube();
  CHECK(flips(box, 2, 1));
  CHECK_FALSE(flips(box, 0, 1));
  CHECK_FALSE(flips(kite(), 2, 0));  // a border
  EditableMesh mesh(kite());
  EmbeddingGuard guard(mesh, 0);
  const Index edge = halfedge_of(mesh, 0, 1);
  mesh.set_feature(edge, true);
  CHECK_FALSE(flip_edge(mesh, guard, edge));
  mesh.set_feature(edge, false);
  CHECK(flip_edge(mesh, guard, edge));
  CHECK_FALSE(flips(kite(2), 0, 1));  // its faces meet at 2 atan 2 = 127 degrees
}

TEST_CASE("a flip that would intersect another part of the surface is refused") {
  // The old edge lies at z = 0, the new one at z = -0.4.
  CHECK(flips(kite(0.4), 0, 1));
  CHECK_FALSE(flips(joined(kite(0.4), needle(-0.6, -0.1)), 0, 1));
  CHECK(flips(joined(kite(0.4), needle(-0.9, -0.5)), 0, 1));
  const Flipped result = flipped(joined(kite(0.4), needle(-0.6, -0.1)), FlipRule::angle);
  CHECK(result.counts.refused > 0);
  CHECK(has_edge(result.mesh, 0, 1));
}
