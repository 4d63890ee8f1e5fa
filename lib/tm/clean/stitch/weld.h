/// Joins positions that are equal or close.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// For each position the smallest index of those that it is joined with: equal positions, or all
/// that a chain of steps of at most `tolerance` connects. O(n) on usual data; deterministic.
std::vector<Index> weld(const std::vector<Vec3>& positions, double tolerance);

/// For each position the index of one no farther than `distance` (positive) that it may take: of
/// the nearest of those that keep theirs. The first `fixed` positions do; of the others those that
/// are far from all before. Unlike chains, this moves nothing by more than the distance.
/// O(n) on usual data; deterministic.
std::vector<Index> gather(const std::vector<Vec3>& positions, std::size_t fixed, double distance);

}  // namespace transformesh
