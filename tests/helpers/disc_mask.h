/// Masks of shapes with known distance functions, such as a disc, for tests of silhouettes.
#pragma once

#include <algorithm>
#include <cmath>

#include "transformesh/image.h"

namespace transformesh::test {

inline constexpr int width = 64;
inline constexpr int height = 48;

/// Returns a mask with a soft contour. `distance` is the signed distance from the contour in
/// pixels, positive outside.
template <typename Function>
GrayImage soft_mask(const Function& distance) {
  GrayImage mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      mask.at(x, y) = std::clamp(127.5F - 80 * static_cast<float>(distance(x, y)), 0.0F, 255.0F);
  return mask;
}

/// Returns the signed distance from the disc's circle in pixels, positive outside.
inline double disc(double x, double y) { return std::hypot(x - 30.3, y - 22.6) - 11.7; }
template <typename Function>
double worst_error(const GrayImage& distances, const Function& exact) {
  double worst = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      worst = std::max(worst, std::abs(distances.at(x, y) - exact(x, y)));
  return worst;
}

}  // namespace transformesh::test
