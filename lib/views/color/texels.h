/// Enumerates the texels (pixels of a texture) whose centers are in a triangle.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace transformesh {

/// Calls action(x, y, weights) for each texel of a `width` x `height` texture whose center is in
/// the triangle. Texel centers have integer coordinates. A center is in the triangle if its
/// barycentric weights are at least `inside`. If `inside` is negative, centers slightly outside are
/// accepted as well. Degenerate triangles have no texels.
template <class Action>
void for_texels(const std::array<Eigen::Vector2d, 3>& corners, double inside, int width, int height,
                const Action& action) {
  const Eigen::Vector2d a = corners[1] - corners[0];
  const Eigen::Vector2d b = corners[2] - corners[0];
  const double area = a.x() * b.y() - a.y() * b.x();
  if (area == 0) return;
  const Eigen::Vector2d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Eigen::Vector2d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const int last_x = std::min(static_cast<int>(std::floor(high.x())), width - 1);
  const int last_y = std::min(static_cast<int>(std::floor(high.y())), height - 1);
  for (int y = std::max(static_cast<int>(std::ceil(low.y())), 0); y <= last_y; ++y) {
    for (int x = std::max(static_cast<int>(std::ceil(low.x())), 0); x <= last_x; ++x) {
      const Eigen::Vector2d p = Eigen::Vector2d(x, y) - corners[0];
      const double second = (p.x() * b.y() - p.y() * b.x()) / area;
      const double third = (a.x() * p.y() - a.y() * p.x()) / area;
      const double first = 1 - second - third;
      if (first >= inside && second >= inside && third >= inside)
        action(x, y, std::array{first, second, third});
    }
  }
}

}  // namespace transformesh
