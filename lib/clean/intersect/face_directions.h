/// Sides of the coordinate axes to which a face certainly looks: sufficient conditions under which
/// faces cannot intersect (embedded_stars.h, intersection_free_regions.h).
#pragma once

#include <cstdint>

#include "mesh/mesh.h"

namespace transformesh {

/// Bit 2 * axis for up that axis, the bit above for down.
using AxisDirections = std::uint8_t;
inline constexpr AxisDirections all_axis_directions = 0x3f;

struct FaceDirections {
  AxisDirections looks = 0;  ///< the projection along the axis has an area of that sign for certain
  AxisDirections leans = 0;  ///< of these, those within 60 degrees of the normal, or nearly so
};

FaceDirections directions_of_face(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
