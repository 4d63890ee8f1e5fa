#include "remesh/halfedges/vertex_rings.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

/// Returns whether every two consecutive neighbors are corners of a face at the vertex, in this
/// order, and whether these are all of its faces.
bool goes_around(const Mesh& mesh, Index vertex, std::span<const Index> ring) {
  std::size_t faces = 0;
  for (const Face& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (face[i] != vertex) continue;
      ++faces;
      bool is_found = false;
      for (std::size_t k = 0; k + 1 < ring.size(); ++k)
        is_found |= ring[k] == face[(i + 1) % 3] && ring[k + 1] == face[(i + 2) % 3];
      if (!is_found) return false;
    }
  }
  return ring.size() == faces + 1;
}

}  // namespace

TEST_CASE("rings go around vertices, and from border to border") {
  for (const Mesh& mesh : {test::icosphere(3), test::grid(6), test::torus(2, 0.5, 60, 30)}) {
    for (const int threads : {1, 4}) {
      const ThreadLimit limit(threads);
      const EditableMesh editable(mesh);
      const VertexRings rings(editable);
      std::vector<Index> alone;
      for (Index v = 0; v < mesh.positions.size(); ++v) {
        REQUIRE(goes_around(mesh, v, rings[v]));
        CHECK((rings[v].front() == rings[v].back()) == !editable.is_border_vertex(v));
        CHECK(rings[v].front() == editable.target(editable.outgoing(v)));
        find_ring(editable, v, alone);
        CHECK(std::vector<Index>(rings[v].begin(), rings[v].end()) == alone);
      }
    }
  }
}

TEST_CASE("vertices that are gone have no ring, and leave those of others alone") {
  EditableMesh mesh(test::icosphere(2));
  const Index edge = mesh.outgoing(20);
  REQUIRE(mesh.can_collapse(edge));
  mesh.collapse(edge, mesh.position(mesh.target(edge)), 0);
  const VertexRings rings(mesh);
  CHECK(rings[20].empty());
  for (Index v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.has_vertex(v)) CHECK(rings[v].size() == mesh.valence(v) + 1);
}
