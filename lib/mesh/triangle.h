/// Faces as triangles in space.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

using Triangle = std::array<Vec3, 3>;

inline Triangle triangle_of(std::span<const Vec3> positions, const Face& face) {
  return {positions[face[0]], positions[face[1]], positions[face[2]]};
}
inline Triangle triangle_of(const Mesh& mesh, Index face) {
  return triangle_of(mesh.positions, mesh.faces[face]);
}

/// Returns twice the area times the unit normal.
inline Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

/// Returns the cotangent of the angle between two vectors, clamped to 5 to 175 degrees.
inline double clamped_cotangent(const Vec3& a, const Vec3& b) {
  constexpr double largest = 11.430052302761343;  // cotangent of 5 degrees
  const double cross = a.cross(b).norm();
  const double dot = a.dot(b);
  if (std::abs(dot) >= largest * cross) return dot < 0 ? -largest : largest;
  return dot / cross;
}

}  // namespace transformesh
