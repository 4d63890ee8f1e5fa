/// Finds positions that are equal or close, for joining vertices in the first step of stitching
/// (paper 3.3). The caller has to change faces and columns. Positions must be finite.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns for each position the smallest index in its cluster. Two positions are in the same
/// cluster if a chain of positions connects them in which the distance of consecutive positions is
/// at most `tolerance`. O(n log n), also if many positions are within the tolerance of each other;
/// deterministic.
std::vector<Index> weld_positions(const std::vector<Vec3>& positions, double tolerance);

}  // namespace transformesh
