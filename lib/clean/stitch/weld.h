/// Joins positions that are equal or close: the first step of stitching (paper 3.3). Columns and
/// faces are for the caller, who replaces what takes the position of another. Positions are finite.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// For each position the smallest index of those that it is joined with: equal positions, or all
/// that a chain of steps of at most `tolerance` connects. O(n log n), heaps of points within the
/// tolerance included; deterministic.
std::vector<Index> weld_positions(const std::vector<Vec3>& positions, double tolerance);

}  // namespace transformesh
