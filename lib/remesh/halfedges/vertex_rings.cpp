#include "remesh/halfedges/vertex_rings.h"

#include <algorithm>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t initial_capacity = 6;  ///< initial capacity; affects time only

void append_ring(const EditableMesh& mesh, Index vertex, std::vector<Index>& ring) {
  ring.push_back(mesh.target(mesh.outgoing(vertex)));
  mesh.for_each_outgoing(vertex, [&](Index halfedge) { ring.push_back(mesh.apex(halfedge)); });
}

}  // namespace

void find_ring(const EditableMesh& mesh, Index vertex, std::vector<Index>& ring) {
  ring.clear();
  append_ring(mesh, vertex, ring);
}

VertexRings::Chunk VertexRings::chunk_of(const EditableMesh& mesh, Index first, Index last) {
  Chunk chunk;
  chunk.neighbors.reserve((initial_capacity + 1) * (last - first));
  chunk.ends.reserve(last - first + 1);
  chunk.ends.push_back(0);
  for (Index v = first; v < last; ++v) {
    if (mesh.has_vertex(v)) append_ring(mesh, v, chunk.neighbors);
    chunk.ends.push_back(static_cast<Index>(chunk.neighbors.size()));
  }
  return chunk;
}

VertexRings::VertexRings(const EditableMesh& mesh)
    : chunks_((mesh.vertex_slots() + chunk_size - 1) / chunk_size) {
  parallel_for(chunks_.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const Index first = static_cast<Index>(i) * chunk_size;
      chunks_[i] = chunk_of(mesh, first, std::min(first + chunk_size, mesh.vertex_slots()));
    }
  });
}

}  // namespace transformesh
