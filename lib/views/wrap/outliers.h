/// Outliers among points: those so far from the others that a wrap of all would be about them. They
/// are found by the distance to the sixth neighbor, in decreasing order over all points. If one of
/// the first twentieth of these distances is at least four times the next one, all up to there are
/// outliers. No surface is sampled so: where samples grow sparse, distances grow by and by, however
/// uneven the sampling is. (CGAL's remove_outliers() takes a share or a length that is given.)
///
/// Clouds of 100 to 6000 points of which any were dropped, of 60 each, and groups of three points
/// beside 1500 on a sphere that were not, of 20 each, for half and twice that factor:
///
///     factor                                              2       4       8
///     even, noisy, density falling 1000 : 1               0       0       0
///     log-normal; lidar on a plane                    13; 6    0; 0    0; 0
///     density jumping 100 : 1; 1000 : 1 (few points)  4; 30   0; 10    0; 0
///     three at .5; 1; 2 radii from the sphere       0; 0; 0  20; 0; 0  20; 20; 0
///
/// More than six outliers beside each other are not distinguished from a small body; among fewer
/// than 100 points there are none. Equal points count once. Deterministic for any number of
/// threads; O(n log n).
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

/// Indices of the outliers, ascending. Throws InputError if the points are too far apart or too
/// close to measure, as wrapping does.
std::vector<Index> find_outliers(std::span<const Vec3> points);

}  // namespace transformesh
