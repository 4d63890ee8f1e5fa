/// Joins positions that are equal or close: the first step of stitching (paper 3.3), and of merging
/// what rounding all but unites (paper 4.3). Columns and faces are for the caller, who replaces
/// what takes the position of another. Positions are finite.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// For each position the smallest index of those that it is joined with: equal positions, or all
/// that a chain of steps of at most `tolerance` connects. O(n log n), heaps of points within the
/// tolerance included; deterministic.
std::vector<Index> weld_positions(const std::vector<Vec3>& positions, double tolerance);

/// Snaps positions to others nearby: for each position the index of the one that it takes. The
/// first `fixed` positions keep theirs, and so does each of the others that is farther than
/// `distance` (positive) from all before it that do. The rest take the nearest position that is
/// kept. Unlike welding, which follows chains, this moves nothing by more than the distance. O(n
/// log n) on usual data; deterministic.
std::vector<Index> snap_positions(const std::vector<Vec3>& positions, std::size_t fixed,
                                  double distance);

}  // namespace transformesh
