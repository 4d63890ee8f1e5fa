/// Joins the sides of patches that bound the same cell of space, but belong to different connected
/// sets of patches. A patch is a part of the surface between intersection curves (patches.h). Each
/// connected set has one outer cell, which is unbounded if the set is considered alone. If bounded
/// cells of other sets contain the set, its outer cell is joined with the smallest of them.
/// Otherwise it is joined with the unbounded cell of the arrangement. Cost: O(n) for each pair of a
/// set and a cell of another set whose bounding box contains the set. Volumes and winding numbers
/// are computed in floating point. Therefore sets of patches must be farther apart than rounding
/// errors. Deterministic.
#pragma once

#include "clean/exterior/patches.h"

namespace transformesh {

/// Joins elements of `sides`, which join_sides_around_edges() returned, and returns a side of the
/// unbounded cell. There must be at least one patch, and no patch may have a border.
Index join_nested_cells(const Arrangement& arrangement, const Patches& patches,
                        DisjointSets& sides);

}  // namespace transformesh
