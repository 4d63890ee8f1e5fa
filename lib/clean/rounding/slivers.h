/// Flips slivers (paper 4.3). Rounding easily reverses triangles whose height is only a few grid
/// steps (vertex_grids.h), and then they intersect their neighbors. A flip replaces the longest
/// edge of a sliver by the other diagonal of the sliver and the neighbor at this edge. The effect
/// is that the sliver vanishes, and its third corner splits the neighbor. The surface moves by at
/// most the height of the sliver. Two slivers that are neighbors along two edges vanish. No vertex
/// moves; a closed mesh stays closed; both new triangles have the columns of the neighbor.
/// Deterministic. Cost: O(n + k log k) for k faces, with at most three flips per face.
#pragma once

#include <vector>

#include "clean/rounding/vertex_grids.h"

namespace transformesh {

/// Flips the longest edge of each of `faces` whose height over this edge is at most `steps` grid
/// steps at the opposite corner. Equal positions must have equal indices. Faces that vanish stay in
/// the list, but refer to a vertex twice. Returns true if a face was flipped; adds the displacement
/// to `moved`.
bool flip_slivers(Assembly& assembly, const std::vector<Index>& faces, double steps,
                  const VertexGrids& grids, Displacement& moved);

}  // namespace transformesh
