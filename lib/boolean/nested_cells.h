/// Joins the sides of patches that bound the same cell of space but belong to different connected
/// sets of patches. Each connected set has one outer cell. If cells of other sets contain the
/// connected set, the outer cell is part of the smallest of them; otherwise it is part of the
/// unbounded cell of the arrangement. Cost: O(n) for each set in the bounding box of a cell of
/// another set. Volumes and winding numbers are floating point: sets of patches must be farther
/// apart than rounding errors. Deterministic.
#pragma once

#include "clean/exterior/patches.h"

namespace transformesh {

/// Joins elements of `sides`, which join_sides_around_edges() returned, and returns a side of the
/// unbounded cell. There must be at least one patch, and no patch may have a border.
Index join_nested_cells(const Arrangement& arrangement, const Patches& patches,
                        DisjointSets& sides);

}  // namespace transformesh
