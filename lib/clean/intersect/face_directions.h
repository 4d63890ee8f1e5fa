/// Axis directions in which a face has positive projected area. They prove that faces cannot meet
/// (embedded_stars.h, intersection_free_regions.h).
#pragma once

#include <cstdint>

#include "transformesh/mesh.h"

namespace transformesh {

/// Set of axis directions. Bit 2 * axis is the positive direction of that axis, bit 2 * axis + 1
/// the negative direction.
using AxisDirections = std::uint8_t;
inline constexpr AxisDirections all_axis_directions = 0x3f;  ///< six bits, one per direction

struct FaceDirections {
  AxisDirections looks = 0;  ///< directions in which the projected area is certainly positive
  AxisDirections leans = 0;  ///< subset of `looks` within about 60 degrees of the normal
};

FaceDirections directions_of_face(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
