/// How far apart points of a sampled surface are.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the side of the square that the median point has for itself. It is .72 times the
/// distance to the sixth neighbor, because a disk of that radius around a point holds six others.
/// Returns 0 for fewer than seven points. Points must be distinct. Deterministic; O(n log n).
double point_spacing(std::span<const Vec3> points);

}  // namespace transformesh
