/// How far apart points of a sampled surface are.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the side of the square that a point has for itself, of the median point: .72 times the
/// distance to its sixth neighbor, as a disk of that radius around a point holds six others.
/// Returns 0 for fewer than seven points. Points must be distinct. Deterministic; O(n log n).
double point_spacing(std::span<const Vec3> points);

}  // namespace transformesh
