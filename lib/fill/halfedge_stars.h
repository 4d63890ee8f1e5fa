/// The halfedges that leave each vertex of a closed oriented manifold, counter-clockwise. They stay
/// right where the faces around a vertex do, whatever is changed elsewhere.
/// O(n) to make; deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class HalfedgeStars {
 public:
  HalfedgeStars(const Mesh& mesh, std::vector<Index> opposites);

  const std::vector<Index>& opposites() const { return opposites_; }

  /// Calls visit(halfedge) for each of them, beginning with any.
  template <class Visit>
  void visit(Index vertex, const Visit& visit) const {
    Index h = leaving_[vertex];
    do {
      visit(h);
      h = opposites_[previous_halfedge(h)];
    } while (h != leaving_[vertex]);
  }

  /// All of them, beginning with that to `first`.
  std::vector<Index> from(const Mesh& mesh, Index vertex, Index first) const;

 private:
  std::vector<Index> opposites_;  ///< of each halfedge
  std::vector<Index> leaving_;    ///< one of each vertex
};

}  // namespace transformesh
