/// A separable blur with three weights, along rows and then along columns, as at_scale() uses at
/// scale 1. It is computed whenever an image of bytes is read; the blurred image is not stored.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace transformesh {

struct ThreeTapBlur {
  std::array<float, 3> inside{};
  /// Weights at the first and the last pixel of a row or column, where one neighbor is missing.
  std::array<float, 2> first{}, last{};
};

/// Writes a rectangle of the blurred image, row by row. The rectangle begins at `start` (column,
/// row). Sums run from lower to higher indices, for reproducible rounding. Width and height of the
/// image must be at least 2.
void blur_rectangle(const std::vector<std::uint8_t>& bytes, int width, int height,
                    const ThreeTapBlur& taps, const std::array<int, 2>& start, int columns,
                    int rows, float* out);

}  // namespace transformesh
