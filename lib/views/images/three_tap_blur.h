/// A separable blur with three weights per axis, which at_scale() applies to images at full
/// resolution. It is computed while pixels of an 8-bit image are read, so that the blurred image
/// need not be stored.
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

/// Writes a rectangle of the blurred image to `out`, row by row. The rectangle begins at `start`
/// (column, row). Weighted pixels are added from lower to higher indices, for reproducible
/// rounding. Width and height of the image must be at least 2.
void blur_rectangle(const std::vector<std::uint8_t>& bytes, int width, int height,
                    const ThreeTapBlur& taps, const std::array<int, 2>& start, int columns,
                    int rows, float* out);

}  // namespace transformesh
