/// A double cone, whose two apexes are vertices of high valence.
#pragma once

#include <cmath>
#include <numbers>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Returns a circle of n vertices around the axis (1, 2, 3), and two apexes with n faces each. The
/// axis is oblique so that bounding boxes of faces overlap.
inline Mesh double_cone(Index n) {
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  const Vec3 u = axis.unitOrthogonal(), w = axis.cross(u);
  Mesh mesh;
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.positions.push_back(std::cos(angle) * u + std::sin(angle) * w);
    mesh.faces.push_back({i, (i + 1) % n, n});
    mesh.faces.push_back({(i + 1) % n, i, n + 1});
  }
  mesh.positions.push_back(axis);
  mesh.positions.push_back(-axis);
  return mesh;
}

}  // namespace transformesh::test
