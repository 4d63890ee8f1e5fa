/// Joins positions that are equal or close: the first step of stitching (paper 3.3). The caller
/// updates columns and faces. Positions must be finite.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns for each position the smallest index of its cluster. A cluster contains all positions
/// that are connected by a chain of steps of at most `tolerance`. O(n log n), also if many points
/// are within the tolerance of each other; deterministic.
std::vector<Index> weld_positions(const std::vector<Vec3>& positions, double tolerance);

}  // namespace transformesh
