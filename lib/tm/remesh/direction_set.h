/// Sets of directions in space, one bit each: the normals that look a common way are told by one
/// bitwise and (the idea of the normal cone: Volino & Magnenat-Thalmann, "Efficient self-collision
/// detection on smoothly discretized surface animations", Eurographics 1994).
#pragma once

#include <cstdint>

#include "tm/remesh/triangle_contact.h"

namespace transformesh {

/// Of 26 directions: to the sides, edges and corners of a cube.
using DirectionSet = std::uint32_t;
inline constexpr DirectionSet all_directions = 0x1fff1fff;

/// Those that clearly see the front of a face with that normal; none where its length is not
/// between 1e-30 and 1e30.
DirectionSet seeing_directions(const Vec3& normal);

struct Direction {
  DirectionSet bit = 0;
  Vec3 unit = Vec3::Zero();
};
/// Of a set that is not empty, the direction nearest to that of a vector.
Direction nearest_direction(DirectionSet set, const Vec3& vector);

/// Whether any one direction, of unit length, clearly sees the front of the triangle.
bool sees(const Vec3& direction, const Triangle& triangle);

}  // namespace transformesh
