/// A disc whose distance to every pixel is known, for tests of silhouettes.
#pragma once

#include <algorithm>
#include <cmath>

#include "views/images/gray_image.h"

namespace transformesh::test {

inline constexpr int width = 64;
inline constexpr int height = 48;

/// An image whose intensities are those of a function of the place, positive outside, cut off.
template <typename Function>
GrayImage soft_mask(const Function& distance) {
  GrayImage mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      mask.at(x, y) = std::clamp(127.5F - 80 * static_cast<float>(distance(x, y)), 0.0F, 255.0F);
  return mask;
}

/// The distance to the disc's circle, positive outside.
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
