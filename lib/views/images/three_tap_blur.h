/// A separable blur with three weights, along rows and then along columns, as at_scale() does at
/// scale 1. It is computed whenever an image of bytes is read: the blurred image is not stored.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace transformesh {

struct ThreeTapBlur {
  std::array<float, 3> inside{};
  /// At the first and at the last pixel, of the two that are there.
  std::array<float, 2> first{}, last{};
};

/// Writes the part of the blurred image that begins at (column, row), `columns` wide, one row after
/// the other; sums go from the lower to the higher pixel. The image is two pixels wide and high at
/// least.
void blur_rectangle(const std::vector<std::uint8_t>& bytes, int width, int height,
                    const ThreeTapBlur& taps, const std::array<int, 2>& start, int columns,
                    int rows, float* out);

}  // namespace transformesh
