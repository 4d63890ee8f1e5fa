/// Cross sections as drawings.
#pragma once

#include <string>

#include "transformesh/select.h"

namespace transformesh {

/// An SVG of the segments, seen against the normal of the plane: one unit is one unit of the mesh.
/// Axes of the drawing are axes of space if the plane is across one.
std::string section_svg(const std::vector<std::pair<Vec3, Vec3>>& segments, const Vec3& normal);

}  // namespace transformesh
