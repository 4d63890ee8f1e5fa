/// Normal cones of parts of a surface. A cone is stored as a set of directions: all of 26 fixed
/// directions that are in front of every face of the part. The cone of the union of two parts is
/// the bitwise AND of their cones. Reference: Volino & Magnenat-Thalmann, "Efficient self-collision
/// detection on smoothly discretized surface animations", Eurographics 1994. Departure: fixed
/// directions instead of exact cones.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle.h"
#include "remesh/halfedges/number_pair.h"

namespace transformesh {

/// A set of directions, with one bit for each direction from the center of a cube to a side, an
/// edge or a corner.
using NormalCone = std::uint32_t;
/// The set of all directions: the cone of a part of the surface without faces.
inline constexpr NormalCone all_directions = 0x1fff1fff;

/// Returns the normal of a triangle (normal_of), or zero if rounding errors may rotate it by more
/// than a millionth of a radian because the triangle is thin. The cone of zero is empty.
inline Vec3 reliable_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  // The square of the least sine for which rounding errors are below a millionth of the cross
  // product. Rounding errors are below 1e-15 of the product of both lengths.
  constexpr double least_squared_sine = 1e-18;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 normal = ab.cross(ac);
  const double lengths = ab.squaredNorm() * ac.squaredNorm();
  return normal.squaredNorm() < least_squared_sine * lengths ? Vec3(Vec3::Zero()) : normal;
}

/// Returns the directions that are clearly in front of faces with all these normals. Returns no
/// direction if the length of a normal is not between 1e-30 and 1e30.
NormalCone common_cone(std::span<const Vec3> normals);
/// Returns the common cone of `count` normals, which are stored in pairs.
NormalCone common_cone(std::span<const NormalPair> pairs, std::size_t count);
/// Computes the cone of each normal.
void find_cones(std::span<const Vec3> normals, std::span<NormalCone> cones);

struct Direction {
  NormalCone bit = 0;
  Vec3 unit = Vec3::Zero();
};
/// Returns the direction in a cone with the smallest angle to `vector`. The cone must not be empty.
Direction nearest_direction(NormalCone cone, const Vec3& vector);

/// True if a direction is clearly in front of the triangle. The direction must have unit length,
/// and need not be one of the 26 directions of cones.
bool sees(const Vec3& direction, const Triangle& triangle);

}  // namespace transformesh
