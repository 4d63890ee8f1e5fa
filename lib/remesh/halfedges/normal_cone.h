/// Normal cones: what the normals of a part of a surface have in common (Volino &
/// Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized surface
/// animations", Eurographics 1994). A cone is kept as the set of directions, out of 26, that look
/// at the front of every face of the part; the cone of two parts together is one bitwise and.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle.h"
#include "remesh/halfedges/number_pair.h"

namespace transformesh {

/// One bit for each direction to a side, an edge or a corner of a cube.
using NormalCone = std::uint32_t;
/// The cone of no face at all.
inline constexpr NormalCone all_directions = 0x1fff1fff;

/// The normal of a triangle (normal_of), or zero if the triangle is so thin that rounding error may
/// turn that normal by more than a millionth of a radian. Zero has an empty cone.
inline Vec3 reliable_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  // Rounding errors of a cross product are below 1e-15 of the product of both lengths; this is the
  // square of the least sine for which they are below a millionth of the result.
  constexpr double least_squared_sine = 1e-18;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 normal = ab.cross(ac);
  const double lengths = ab.squaredNorm() * ac.squaredNorm();
  return normal.squaredNorm() < least_squared_sine * lengths ? Vec3(Vec3::Zero()) : normal;
}

/// The directions that clearly see the front of a face with that normal; none where its length is
/// not between 1e-30 and 1e30.
NormalCone cone_of(const Vec3& normal);
/// What the cones of all the normals have in common: several times as fast as one by one.
NormalCone common_cone(std::span<const Vec3> normals);
/// The same of `count` normals in pairs.
NormalCone common_cone(std::span<const NormalPair> pairs, std::size_t count);
/// The cone of each normal.
void find_cones(std::span<const Vec3> normals, std::span<NormalCone> cones);

struct Direction {
  NormalCone bit = 0;
  Vec3 unit = Vec3::Zero();
};
/// The direction of a cone, which is not empty, that is nearest to that of a vector.
Direction nearest_direction(NormalCone cone, const Vec3& vector);

/// Whether a direction of unit length, which need not be one of the 26, clearly sees the front of
/// the triangle.
bool sees(const Vec3& direction, const Triangle& triangle);

}  // namespace transformesh
