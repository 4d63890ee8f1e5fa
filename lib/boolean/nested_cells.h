/// Joins the cells of space that an arrangement has in several parts: around each connected set of
/// patches lies a cell which continues one of another set. Cost: O(n) for each set within the box
/// of a cell of another set. Volumes and winding numbers are floating point: sets of patches have
/// to be farther from each other than rounding. Deterministic.
#pragma once

#include "clean/exterior/patches.h"

namespace transformesh {

/// `sides` are those of join_sides_around_edges(), where no patch has a border. Returns a side of
/// the unbounded cell. `patches` has at least one patch.
Index join_nested_cells(const Arrangement& arrangement, const Patches& patches,
                        DisjointSets& sides);

}  // namespace transformesh
