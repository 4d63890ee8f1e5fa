/// Joins positions that are equal or close.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// For each position the smallest index of those that it is joined with: equal positions, or all
/// that a chain of steps of at most `tolerance` connects. O(n) on usual data; deterministic.
std::vector<Index> weld(const std::vector<Vec3>& positions, double tolerance);

}  // namespace transformesh
