/// Finds points so far from the others that a wrap of all points would follow them. The criterion
/// is the distance to the sixth neighbor. All points are sorted by this distance in decreasing
/// order. If one of the first twentieth of the distances is at least four times the next one, all
/// points up to there are outliers. On sampled surfaces there is no such jump: even if the sampling
/// is uneven, distances increase gradually as samples become sparse. Unlike here, CGAL's
/// remove_outliers() needs a given fraction or length.
///
/// The table shows how sensitive the result is to the factor of four. The first three rows count
/// the clouds that lost any point, of 60 clouds with 100 to 6000 points each. The last row counts
/// groups of three outliers that were not found, of 20 groups each, beside 1500 points on a sphere.
///
///     factor                                              2       4       8
///     even, noisy, density falling 1000 : 1               0       0       0
///     log-normal; lidar on a plane                    13; 6    0; 0    0; 0
///     density jumping 100 : 1; 1000 : 1 (few points)  4; 30   0; 10    0; 0
///     three at .5; 1; 2 radii from the sphere       0; 0; 0  20; 0; 0  20; 20; 0
///
/// More than six adjacent outliers are indistinguishable from a small body. Clouds of fewer than
/// 100 points have no outliers. Equal points count once. Deterministic for any number of threads;
/// O(n log n).
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the indices of the outliers, ascending. Throws InputError if the points are too far
/// apart or too close for wrapping (ScaleNormalization).
std::vector<Index> find_outliers(std::span<const Vec3> points);

}  // namespace transformesh
