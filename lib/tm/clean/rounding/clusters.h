/// Clusters: many points about one place that would be one point but for rounding. Where hundreds
/// of faces pass through a point, each stored a little off, all their intersections lie about it,
/// the farther off the flatter two of them meet. How far is known only from the points themselves.
///
/// A cluster is at least 30 points in a box of some size along all axes, with no other point as
/// near as that size to any of them, and with an extent of less than four spacings for each point.
/// So it is told apart from all around it, however far it spreads, and is too dense to be a part of
/// a mesh. Sizes are the spacing times powers of two up to 2^12; a point belongs to the cluster of
/// the smallest size for which it is in one. Cost: O(n log n). Deterministic.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// The size of the widest cluster, in spacings.
constexpr double widest_cluster = 0x1p12;

/// The bounding box of a group of positions.
Eigen::AlignedBox3d box_of_group(const std::vector<Vec3>& positions,
                                 const std::vector<Index>& group);

/// The indices of the points of each cluster, ascending. Positions are distinct; the spacing is a
/// power of two, the least by which coordinates as large as theirs differ.
std::vector<std::vector<Index>> find_clusters(const std::vector<Vec3>& positions, double spacing);

}  // namespace transformesh
