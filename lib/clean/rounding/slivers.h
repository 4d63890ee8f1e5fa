/// Flips slivers away (paper 4.3): triangles that are lower than a few spacings of numbers turn
/// over at the least rounding, and intersect what is beside them. The longest edge of a sliver is
/// replaced by the other diagonal of it and its neighbor, so that its apex splits that neighbor;
/// the surface moves by no more than the sliver's height. Two slivers that are each other's
/// neighbors along two edges vanish. No vertex moves; what is closed stays closed; pieces take
/// columns of the neighbor. Deterministic. Cost: O(n + k log k) for k faces and a bounded number of
/// flips of each.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "clean/rounding/local_distance.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

/// Equal positions have equal indices. `faces` are those that are flipped if they are lower than
/// `spacings` at their apex. Vanished faces name a vertex twice. Returns the largest height.
Displacement flip_slivers(Assembly& assembly, const std::vector<Index>& faces, double spacings,
                          const Spacings& spacing);

}  // namespace transformesh
