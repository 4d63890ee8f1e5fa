/// Finds outliers: points so far from the others that a surface around all points (alpha wrap,
/// Poisson surface) would extend to them.
///
/// The spacing at a point is the distance to its sixth neighbor. Neighbors are connected if their
/// distance is at most twice the spacing at both. Connected groups of at least a twentieth of the
/// points are bodies. A point in no body is an outlier if the spacing at it is at least four times
/// the spacing at the nearest point of a body. Breunig, Kriegel, Ng & Sander, "LOF: identifying
/// density-based local outliers", SIGMOD 2000, compare the density at a point with that at its
/// neighbors. Here, it is compared with that at bodies, because the neighbors of outliers are often
/// outliers.
///
/// The table shows how the result depends on both factors: twice the spacing for connections, and
/// four times the spacing for outliers. The first two rows count outliers that were not found, of
/// 665 and 3325. They were among 66,500 points on spheres, tori and boxes with noise of .5 %. They
/// were spread evenly over a cube of twice the size, so that some are on the surface. The other
/// rows count point clouds without outliers of which any point was called an outlier. Each of these
/// rows is for 44 clouds of 300 to 20,000 points.
///
///     factors (connection, spacing)                 2, 4  3, 4  1, 4  2, 6
///     1 % of outliers around the body                 46    85    46    71
///     5 %                                            467  3282   223   775
///     even, noisy, density falling 1000 : 1            0     0     0     0
///     lidar on a plane (at most .7 % of its points)    4     1    27     2
///     density jumping 100 : 1 (at most .8 %)          13     3    28     9
///
/// Most outliers that were not found at 5 % belong to clouds of 500 and 5000 points. There, chains
/// of outliers near the surface connect other outliers with the body. All outliers at a distance of
/// 4 to 1000 times the radius of the body were found. In clouds of fewer than 100 points, no point
/// counts as an outlier. Equal points count once. Deterministic for any number of threads; O(n log
/// n).
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the indices of the outliers, ascending. Throws InputError if the points are too far
/// apart or too close for wrapping (ScaleNormalization).
std::vector<Index> find_outliers(std::span<const Vec3> points);

}  // namespace transformesh
