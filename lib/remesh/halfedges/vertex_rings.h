/// The neighbors of every vertex in order, found on all threads: walking from face to face waits
/// for memory, and sweeps that only move vertices need it once. O(n); deterministic.
#pragma once

#include <span>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

class VertexRings {
 public:
  /// They stay right as long as no face of the mesh changes.
  explicit VertexRings(const EditableMesh& mesh);

  /// The neighbors of a living vertex, counter-clockwise, from the target of outgoing(); the first
  /// of them again at the end, unless the vertex lies on a border.
  std::span<const Index> operator[](Index vertex) const {
    const Chunk& chunk = chunks_[vertex / chunk_size];
    const Index* end = chunk.ends.data() + vertex % chunk_size;
    return {chunk.neighbors.data() + end[0], chunk.neighbors.data() + end[1]};
  }

 private:
  static constexpr Index chunk_size = 1024;
  /// Vertices one after the other.
  struct Chunk {
    std::vector<Index> neighbors;
    std::vector<Index> ends;  ///< where those of each vertex begin, and where the last ones end
  };
  static Chunk chunk_of(const EditableMesh& mesh, Index first, Index last);

  std::vector<Chunk> chunks_;
};

/// Replaces what is in `ring` by the neighbors of one vertex.
void find_ring(const EditableMesh& mesh, Index vertex, std::vector<Index>& ring);

}  // namespace transformesh
