/// A slit in a surface along a loop of edges: every vertex of the loop is duplicated, so that the
/// faces on either side have their own vertices. Cost: O(faces around the loop). Deterministic.
#pragma once

#include <utility>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// One side of the loop: data for each vertex of the loop.
struct SlitSide {
  /// Outgoing halfedges 3 * face + corner on this side, counter-clockwise.
  std::vector<std::vector<Index>> corners;
  /// Positions after vertices moved away from the slit, by a third of the way to the mean of their
  /// neighbors on this side. A vertex stays if all its neighbors are on the loop.
  std::vector<Vec3> drawn_back;
  std::vector<std::pair<Index, Index>> chords;  ///< edges between vertices of the loop, in both
                                                ///< directions
};

struct SlitSides {
  SlitSide left, right;
};

/// Pre: `loop` is a simple loop of edges, and the faces at its vertices have not changed since the
/// stars were computed.
SlitSides sides_of(const Mesh& mesh, const std::vector<Index>& loop, const HalfedgeStars& stars);

/// Gives the faces on the right side new vertices with equal positions and columns, which are
/// appended in the order of the loop.
void slit_along(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides);

}  // namespace transformesh
