/// Measures the distance of samples of one mesh from another by testing all faces. Shares no code
/// with the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Returns the squared distance of a point from a segment.
inline double squared_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).squaredNorm();
}

/// Returns the squared distance of a point from a triangle: from its plane if the point projects
/// into the triangle, otherwise from its sides.
inline double squared_to_triangle(const Vec3& p, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[1]);
  bool is_over = normal.squaredNorm() > 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = t[i], &b = t[(i + 1) % 3];
    is_over = is_over && normal.cross(b - a).dot(p - a) >= 0;
    least = std::min(least, squared_to_segment(p, a, b));
  }
  if (!is_over) return least;
  const double height = normal.normalized().dot(p - t[0]);
  return std::min(least, height * height);
}

/// Returns the largest distance of samples of `from` from `to`. Each face has samples at all points
/// whose barycentric coordinates are multiples of 1 / `steps`.
inline double sampled_distance(const Mesh& from, const Mesh& to, int steps) {
  const auto corners = [](const Mesh& mesh, const Face& face) {
    return std::array{mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]};
  };
  double largest = 0;
  std::size_t near = 0;  // the face near the last sample is tested first, which usually decides
  for (const Face& face : from.faces) {
    const auto [a, b, c] = corners(from, face);
    for (int i = 0; i <= steps; ++i)
      for (int k = 0; i + k <= steps; ++k) {
        const Vec3 p =
            a + static_cast<double>(i) / steps * (b - a) + static_cast<double>(k) / steps * (c - a);
        double least = std::numeric_limits<double>::infinity();
        const std::size_t first = near;
        for (std::size_t n = 0; n < to.faces.size(); ++n) {
          const std::size_t other = (first + n) % to.faces.size();
          const double squared = squared_to_triangle(p, corners(to, to.faces[other]));
          if (squared < least) near = other;
          least = std::min(least, squared);
          if (least <= largest) break;  // this sample cannot be the farthest
        }
        largest = std::max(largest, least);
      }
  }
  return std::sqrt(largest);
}

}  // namespace transformesh::test
