/// Opposite halfedges, and the faces at each vertex.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/edges.h"

namespace transformesh {

/// Returns, for every halfedge 3 * face + corner, the halfedge that traverses the same edge in the
/// opposite direction. The value is no_index on a border, on an edge with more than two faces, and
/// if both faces traverse the edge in the same direction. Vertices are identified by index, not by
/// position. O(n); deterministic.
std::vector<Index> opposite_halfedges(const Mesh& mesh);

/// True if the mesh is a closed oriented manifold. `opposites` are those of opposite_halfedges().
/// Parallel. O(n).
bool is_closed_manifold(const Mesh& mesh, std::span<const Index> opposites);

/// Returns `opposites` if the mesh is a closed oriented manifold, otherwise nothing.
std::optional<std::vector<Index>> closed_opposites(const Mesh& mesh, std::vector<Index> opposites);

/// The faces at each vertex in ascending order, stored as one array with offsets.
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
