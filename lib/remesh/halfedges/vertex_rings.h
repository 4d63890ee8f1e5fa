/// Stores the ordered neighbors of all vertices, found in parallel. Walking around a vertex is slow
/// because of cache misses, and sweeps that only move vertices can reuse the rings. O(n);
/// deterministic.
#pragma once

#include <span>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

class VertexRings {
 public:
  /// Rings are valid as long as no face of the mesh changes.
  explicit VertexRings(const EditableMesh& mesh);

  /// Returns the neighbors of a living vertex, counter-clockwise, starting with the target of
  /// outgoing(). The first is repeated at the end, unless the vertex lies on a border.
  std::span<const Index> operator[](Index vertex) const {
    const Chunk& chunk = chunks_[vertex / chunk_size];
    const Index* end = chunk.ends.data() + vertex % chunk_size;
    return {chunk.neighbors.data() + end[0], chunk.neighbors.data() + end[1]};
  }

 private:
  static constexpr Index chunk_size = 1024;  ///< affects time only
  /// Rings of consecutive vertices.
  struct Chunk {
    std::vector<Index> neighbors;
    std::vector<Index> ends;  ///< per vertex: begin of its ring; then the end of the last ring
  };
  static Chunk chunk_of(const EditableMesh& mesh, Index first, Index last);

  std::vector<Chunk> chunks_;
};

/// Replaces the contents of `ring` by the neighbors of a vertex.
void find_ring(const EditableMesh& mesh, Index vertex, std::vector<Index>& ring);

}  // namespace transformesh
