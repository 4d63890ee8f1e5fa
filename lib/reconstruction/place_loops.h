/// Decides whether a part of a closed surface contains a loop around a handle or a tunnel.
#pragma once

#include <optional>
#include <vector>

#include "fill/halfedge_stars.h"
#include "fill/homology.h"
#include "transformesh/mesh.h"

namespace transformesh {

class PlaceLoops {
 public:
  /// Keeps a reference to the mesh. A mesh that is not a closed oriented manifold has no loops.
  explicit PlaceLoops(const Mesh& mesh);

  /// True if a loop of edges between the given vertices does not separate the surface (homology.h).
  /// Precondition: each vertex except the first one is a neighbor of an earlier one. O(n) for n
  /// vertices.
  bool has_handle(const std::vector<Index>& vertices) const;

 private:
  const Mesh& mesh_;
  std::optional<HalfedgeStars> stars_;  ///< empty if the mesh is not closed
  std::vector<HomologyWord> words_;     ///< word of each halfedge
};

}  // namespace transformesh
