/// Measures the spacing of points that sample a surface.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the side of a square whose area is the surface area per point. This side is .72 times
/// the median distance to the sixth neighbor: a disk with that radius has the area of six such
/// squares. Returns 0 for fewer than seven points. Points must be distinct. Deterministic; O(n log
/// n).
double point_spacing(std::span<const Vec3> points);

}  // namespace transformesh
