/// Faces as triangles in space.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "tm/mesh/mesh.h"

namespace transformesh {

using Triangle = std::array<Vec3, 3>;

inline Triangle triangle_of(std::span<const Vec3> positions, const Face& face) {
  return {positions[face[0]], positions[face[1]], positions[face[2]]};
}
inline Triangle triangle_of(const Mesh& mesh, Index face) {
  return triangle_of(mesh.positions, mesh.faces[face]);
}

/// Twice the area times the unit normal.
inline Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

}  // namespace transformesh
