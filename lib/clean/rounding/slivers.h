/// Flips slivers away (paper 4.3): triangles that are lower than a few steps of their grids turn
/// over at the least rounding, and intersect what is beside them. The longest edge of a sliver is
/// replaced by the other diagonal of it and its neighbor, so that its apex splits that neighbor;
/// the surface moves by no more than the sliver's height. Two slivers that are each other's
/// neighbors along two edges vanish. No vertex moves; what is closed stays closed; pieces take
/// columns of the neighbor. Deterministic. Cost: O(n + k log k) for k faces and a bounded number of
/// flips of each.
#pragma once

#include <vector>

#include "clean/rounding/vertex_grids.h"

namespace transformesh {

/// Equal positions have equal indices. `faces` are those that are flipped if they are lower than
/// so many steps at their apex. Vanished faces name a vertex twice. Returns whether a face was
/// flipped, and notes how far the surface moved.
bool flip_slivers(Assembly& assembly, const std::vector<Index>& faces, double steps,
                  const VertexGrids& grids, Displacement& moved);

}  // namespace transformesh
