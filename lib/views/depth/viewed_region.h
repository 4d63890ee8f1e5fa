/// The part of space in which a surface is searched: a box, or the surroundings of the point at
/// which the cameras look.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "transformesh/measure.h"
#include "views/cameras/view.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {

/// Returns a coarse grid whose values are negative at nodes of the region, and at least two cells
/// elsewhere. A node belongs to the region if at least three views show it (two, if there are no
/// more views), and if it is in `box`. Without box, it must be nearer to the viewed point than six
/// tenths of the median distance of the cameras. Throws InputError if no node belongs to the
/// region.
ValueGrid viewed_region(std::span<const View> views, const std::optional<Box>& box);

/// Returns a box around most of the points of a sparse reconstruction. A fiftieth of them at each
/// end along each axis may be outliers and is left out. Then the box is enlarged by a tenth of its
/// size on each side. Returns nothing for fewer than 100 points.
std::optional<Box> box_of_points(std::vector<Vec3> points);

/// Returns the box of the region, enlarged by a cell.
Box box_of(const ValueGrid& region);

}  // namespace transformesh
