#include "remesh/operations/collapse.h"

#include <cmath>

#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "remesh/guards/edge_rules.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

struct Collapsed {
  CollapseCounts counts;
  Mesh mesh;
};

Collapsed collapsed(const Mesh& mesh, const EdgeLimits& limits, bool keep_border = false) {
  EditableMesh editable(mesh);
  EmbeddingGuard guard(editable, limits.longest);
  const VertexRoles roles(editable, keep_border);
  const CollapseCounts counts = collapse_short_edges(editable, guard, roles, limits, {});
  return {counts, editable.to_mesh()};
}

std::size_t collapsed_for_valence(EditableMesh& mesh, const EdgeLimits& limits) {
  EmbeddingGuard guard(mesh, limits.stretched());
  return collapse_for_valence(mesh, guard, VertexRoles(mesh, false), limits, {});
}

std::size_t edges_below(const Mesh& mesh, double length) {
  std::size_t count = 0;
  for (const auto& [ends, faces] : edge_faces(mesh)) {
    const auto& [a, b] = ends;
    count += (mesh.positions[a] - mesh.positions[b]).norm() < length;
  }
  return count;
}

}  // namespace

TEST_CASE("a fine sphere loses its short edges and keeps its volume") {
  const Mesh sphere = icosphere(4);
  const double length = 2.5 * edge_lengths(sphere).mean;
  const auto [counts, mesh] = collapsed(sphere, {length, 3 * length});
  CHECK(counts.done == sphere.positions.size() - mesh.positions.size());
  CHECK(edges_below(mesh, length) == counts.refused);
  CHECK(counts.refused == 0);
  CHECK(is_oriented_manifold(mesh));
  CHECK(is_closed(mesh));
  CHECK(euler_number(mesh) == 2);
  CHECK(volume(mesh) == doctest::Approx(volume(sphere)).epsilon(1e-3));
}

TEST_CASE("meshes without short edges stay unchanged") {
  const Mesh sphere = icosphere(2);
  const auto [counts, mesh] = collapsed(sphere, {0.99 * edge_lengths(sphere).minimum, 10});
  CHECK(counts.done == 0);
  CHECK(is_same(mesh, sphere));
}

TEST_CASE("a tetrahedron keeps its four faces, and counts its short edges") {
  const auto [counts, mesh] = collapsed(tetrahedron(), {10, 20});
  CHECK(counts.done == 0);
  CHECK(counts.refused == 6);
  CHECK(is_same(mesh, tetrahedron()));
}

TEST_CASE("no edge becomes longer than allowed") {
  // In a square grid every collapse makes an edge of more than 1.4 cells.
  const double cell = 1.0 / 8;
  const auto [counts, mesh] = collapsed(grid(8), {1.1 * cell, 1.2 * cell});
  CHECK(counts.done == 0);
  CHECK(counts.refused == 2 * 8 * 9);
  const Collapsed longer = collapsed(grid(8), {1.1 * cell, 4 * cell});
  CHECK(longer.counts.done > 0);
  CHECK(edge_lengths(longer.mesh).maximum <= 4 * cell);
}

TEST_CASE("borders keep their shape, or stay to the bit") {
  const double cell = 1.0 / 8;
  const auto [counts, mesh] = collapsed(grid(8), {1.1 * cell, 4 * cell}, true);
  CHECK(counts.done > 0);
  std::size_t on_border = 0;
  for (const auto& [edge, faces] : edge_faces(mesh)) on_border += faces == 1;
  CHECK(on_border == 4 * 8);
  CHECK(surface_area(mesh) == doctest::Approx(1));
  const Mesh free = collapsed(grid(8), {1.1 * cell, 4 * cell}).mesh;
  CHECK(surface_area(free) == doctest::Approx(1));  // vertices of straight borders move along them
}

TEST_CASE("a vertex that a split has added to a regular torus goes for the valences") {
  const Mesh regular = torus(2, 1, 24, 18);
  EditableMesh mesh(regular);
  const double longest = edge_lengths(regular).maximum;
  const EdgeLimits limits{longest, 1.5 * longest};
  CHECK(collapsed_for_valence(mesh, limits) == 0);
  const Index h = 300;
  mesh.split(h, 0.5 * (mesh.position(mesh.source(h)) + mesh.position(mesh.target(h))));
  CHECK(collapsed_for_valence(mesh, limits) == 1);
  const Mesh result = mesh.to_mesh();
  CHECK(result.faces.size() == regular.faces.size());
  CHECK(valence_six_share(result) == 1);
}

TEST_CASE("for valences only edges up to 1.15 times the shortest length are collapsed") {
  EditableMesh mesh(torus(2, 1, 24, 18));
  const Index h = 300;
  mesh.split(h, 0.5 * (mesh.position(mesh.source(h)) + mesh.position(mesh.target(h))));
  const double half = std::sqrt(mesh.squared_length(h));
  const EdgeLimits limits{0.99 * half / 1.15, 10};
  CHECK(collapsed_for_valence(mesh, limits) == 0);
}
