#include "remesh/halfedges/vertex_rings.h"

#include <algorithm>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t usual_valence = 6;

void append_ring(const EditableMesh& mesh, Index vertex, std::vector<Index>& ring) {
  ring.push_back(mesh.target(mesh.outgoing(vertex)));
  mesh.for_each_outgoing(vertex, [&](Index halfedge) { ring.push_back(mesh.apex(halfedge)); });
}

}  // namespace

void find_ring(const EditableMesh& mesh, Index vertex, std::vector<Index>& ring) {
  ring.clear();
  append_ring(mesh, vertex, ring);
}

VertexRings::Part VertexRings::part_of(const EditableMesh& mesh, Index first, Index last) {
  Part part;
  part.neighbors.reserve((usual_valence + 1) * (last - first));
  part.ends.reserve(last - first + 1);
  part.ends.push_back(0);
  for (Index v = first; v < last; ++v) {
    if (mesh.has_vertex(v)) append_ring(mesh, v, part.neighbors);
    part.ends.push_back(static_cast<Index>(part.neighbors.size()));
  }
  return part;
}

VertexRings::VertexRings(const EditableMesh& mesh)
    : parts_((mesh.vertex_slots() + part_size - 1) / part_size) {
  parallel_for(parts_.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const Index first = static_cast<Index>(i) * part_size;
      parts_[i] = part_of(mesh, first, std::min(first + part_size, mesh.vertex_slots()));
    }
  });
}

}  // namespace transformesh
