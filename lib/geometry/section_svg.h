/// Draws cross sections as SVG.
#pragma once

#include <string>

#include "transformesh/select.h"

namespace transformesh {

/// Returns an SVG drawing of the segments, viewed against the normal of the plane. One unit of the
/// drawing is one unit of the mesh. If the normal is an axis, the axes of the drawing are
/// coordinate axes.
std::string section_svg(const std::vector<std::pair<Vec3, Vec3>>& segments, const Vec3& normal);

}  // namespace transformesh
