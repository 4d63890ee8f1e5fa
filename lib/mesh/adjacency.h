/// Which halfedge lies across each halfedge, and which faces meet at each vertex.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/edges.h"

namespace transformesh {

/// For every halfedge (3 * face + corner) the one that has the opposite direction along the same
/// edge. It is no_index on a border, on an edge with more than two faces, and if both faces
/// traverse the edge in the same direction. Vertices are the same when their indices are. O(n);
/// deterministic.
std::vector<Index> opposite_halfedges(const Mesh& mesh);

/// These, where they are those of a closed oriented manifold; nothing where that is none.
std::optional<std::vector<Index>> closed_opposites(const Mesh& mesh, std::vector<Index> opposites);

/// The faces around each vertex in ascending order, as one array with offsets.
class VertexFaces {
 public:
  explicit VertexFaces(const Mesh& mesh);
  std::span<const Index> operator[](Index vertex) const {
    return {faces_.data() + offsets_[vertex], faces_.data() + offsets_[vertex + 1]};
  }

 private:
  std::vector<Index> offsets_;
  std::vector<Index> faces_;
};

}  // namespace transformesh
