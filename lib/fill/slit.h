/// Cuts a surface open along a loop of edges (a slit): every vertex of the loop is duplicated, so
/// that the faces on each side have their own vertices. Cost: O(faces around the loop).
/// Deterministic.
#pragma once

#include <utility>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// One side of the loop; `corners` and `drawn_back` have an entry for each vertex of the loop.
struct SlitSide {
  /// Outgoing halfedges (3 * face + corner) of the faces on this side, counter-clockwise.
  std::vector<std::vector<Index>> corners;
  /// Position of the vertex after it moved away from the slit, by a third of the way to the mean of
  /// its neighbors on this side. Neighbors on the loop do not count; if there are no others, the
  /// vertex stays.
  std::vector<Vec3> drawn_back;
  /// Edges on this side between vertices of the loop that are not consecutive on the loop, in both
  /// directions.
  std::vector<std::pair<Index, Index>> chords;
};

struct SlitSides {
  SlitSide left, right;
};

/// Returns both sides of a loop. Precondition: `loop` is a simple loop of edges, and the faces at
/// its vertices have not changed since `stars` was computed.
SlitSides sides_of(const Mesh& mesh, const std::vector<Index>& loop, const HalfedgeStars& stars);

/// Cuts the mesh open. The faces on the right side get new vertices with the positions and columns
/// of the loop vertices. The new vertices are appended in the order of the loop.
void slit_along(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides);

}  // namespace transformesh
