/// Distance of a point from a plane. Its sign is exact for the numbers as given.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns (normal * point - offset) / length, where `length` is positive. The result is 0 if and
/// only if the dividend is exactly 0, and has the sign of the exact dividend.
double exact_plane_distance(const Vec3& normal, double offset, double length, const Vec3& point);

}  // namespace transformesh
