/// Flips slivers (paper 4.3). Triangles whose height is only a few grid steps are reversed by any
/// rounding, and then intersect their neighbors. The longest edge of a sliver is replaced by the
/// other diagonal of the sliver and its neighbor. Then the sliver's apex splits the neighbor. The
/// surface moves by at most the height of the sliver. Two slivers that are neighbors along two
/// edges vanish. No vertex moves; a closed mesh stays closed; pieces take the columns of the
/// neighbor. Deterministic. Cost: O(n + k log k) for k faces, with at most three flips per face.
#pragma once

#include <vector>

#include "clean/rounding/vertex_grids.h"

namespace transformesh {

/// Flips each of `faces` whose height is less than `steps` grid steps at its apex. Equal positions
/// must have equal indices. Vanished faces refer to a vertex twice. Returns true if a face was
/// flipped; adds the displacement to `moved`.
bool flip_slivers(Assembly& assembly, const std::vector<Index>& faces, double steps,
                  const VertexGrids& grids, Displacement& moved);

}  // namespace transformesh
