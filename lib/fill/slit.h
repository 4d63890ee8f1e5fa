/// A slit in a surface along a loop of edges: every vertex of the loop is duplicated, so that the
/// faces on either side have their own vertices. Cost: O(faces around the loop). Deterministic.
#pragma once

#include <utility>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The faces on one side of the loop, per vertex of the loop.
struct SlitSide {
  std::vector<std::vector<Index>> corners;  ///< outgoing halfedges 3 * face + corner,
                                            ///< counter-clockwise
  /// Position after moving away from the slit: a third of the way to the mean of the neighbors on
  /// this side. Unchanged if all neighbors are on the loop.
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

/// Gives the faces on the right new vertices: appended in the order of the loop, with equal
/// positions and columns.
void slit_along(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides);

}  // namespace transformesh
