/// The ways that a face looks along the axes, which tell where faces cannot meet (embedded_stars.h,
/// zones.h).
#pragma once

#include <cstdint>

#include "transformesh/mesh.h"

namespace transformesh {

/// Bit 2 * axis for up that axis, the bit above for down.
using Ways = std::uint8_t;
inline constexpr Ways all_ways = 0x3f;

struct FaceWays {
  Ways looks = 0;  ///< the projection along the axis has an area of that sign for certain
  Ways leans = 0;  ///< of these, those within 60 degrees of the normal, or nearly so
};

FaceWays ways_of_face(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
