/// Crowds: many points about one place that would be one point but for rounding. Where hundreds of
/// faces pass through a point, each stored a little off, all their intersections lie about it, the
/// farther off the flatter two of them meet. How far is known only from the points themselves.
///
/// A crowd is at least 30 points in a box of a size, along all axes, with no other point as near as
/// that to any of them, and with at most four spacings along an axis for each point. So what is in
/// it is told apart from all around it, however far it spreads, and is too dense to be a part of a
/// mesh. Of several sizes, the spacing times powers of two up to 2^12, the least for which it is
/// one counts. Cost: O(n log n). Deterministic.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// The widest crowd, in spacings.
constexpr double widest_crowd = 0x1p12;

/// Of some of the positions.
Eigen::AlignedBox3d box_around(const std::vector<Vec3>& positions, const std::vector<Index>& group);

/// The indices of each, ascending. Positions are distinct; the spacing is a power of two, the
/// least by which coordinates as large as theirs differ.
std::vector<std::vector<Index>> find_crowds(const std::vector<Vec3>& positions, double spacing);

}  // namespace transformesh
