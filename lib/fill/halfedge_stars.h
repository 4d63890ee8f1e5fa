/// The outgoing halfedges of each vertex of a closed oriented manifold, counter-clockwise. The list
/// of a vertex stays valid as long as the faces at this vertex do not change. O(n) to construct;
/// deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class HalfedgeStars {
 public:
  HalfedgeStars(const Mesh& mesh, std::vector<Index> opposites);

  const std::vector<Index>& opposites() const { return opposites_; }
  /// True if the vertex has faces.
  bool has(Index vertex) const { return leaving_[vertex] != no_index; }

  /// Calls visit(halfedge) for each outgoing halfedge, counter-clockwise from an unspecified one.
  template <class Visit>
  void visit(Index vertex, const Visit& visit) const {
    Index h = leaving_[vertex];
    do {
      visit(h);
      h = opposites_[previous_halfedge(h)];
    } while (h != leaving_[vertex]);
  }

  /// Returns all outgoing halfedges of a vertex, counter-clockwise, starting with the one that
  /// leads to vertex `first`.
  std::vector<Index> from(const Mesh& mesh, Index vertex, Index first) const;

 private:
  std::vector<Index> opposites_;  ///< opposite of each halfedge
  std::vector<Index> leaving_;    ///< an outgoing halfedge of each vertex
};

}  // namespace transformesh
