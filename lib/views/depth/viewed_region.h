/// Determines the part of space in which a surface is searched: a given box, or a ball around the
/// point at which the cameras look.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "transformesh/measure.h"
#include "views/cameras/view.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {

/// Returns a coarse grid whose values are negative at nodes in the region, and twice the spacing at
/// all other nodes. A node is in the region if at least three views contain it (two, if there are
/// no more views), and if it is in `box`. Without `box`, its distance from the point at which the
/// cameras look must be less than 0.6 times the median distance of the cameras. Throws InputError
/// if no node belongs to the region.
ValueGrid viewed_region(std::span<const View> views, const std::optional<Box>& box);

/// Returns a box around most of the points of a sparse reconstruction. Along each axis, a fiftieth
/// of the points at each end may be outliers and is left out. Then the box is enlarged by a tenth
/// of its size on each side. Returns nothing for fewer than 100 points.
std::optional<Box> box_of_points(std::vector<Vec3> points);

/// Returns the bounding box of the negative nodes, enlarged by one cell.
Box box_of(const ValueGrid& region);

}  // namespace transformesh
