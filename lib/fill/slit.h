/// A slit in a surface along a loop of edges: every vertex of the loop becomes two, one for the
/// faces on either side.
/// Cost: O(faces around the loop). Deterministic.
#pragma once

#include <utility>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// What lies on one side of the loop, per vertex of it.
struct SlitSide {
  std::vector<std::vector<Index>> corners;  ///< 3 * face + corner, counter-clockwise
  /// Where it is drawn back to: a third of the way to the middle of the vertices next to it on this
  /// side; where it is, if there are none but those of the loop.
  std::vector<Vec3> drawn_back;
  std::vector<std::pair<Index, Index>> chords;  ///< edges between vertices of the loop, both ways
};

struct SlitSides {
  SlitSide left, right;
};

/// Pre: `loop` is a simple loop of edges, and since the stars were taken the faces at its
/// vertices are the same.
SlitSides sides_of(const Mesh& mesh, const std::vector<Index>& loop, const HalfedgeStars& stars);

/// Gives new vertices to the faces on the right: behind the others in the order of the loop, at the
/// same places and with the same columns.
void slit_along(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides);

}  // namespace transformesh
