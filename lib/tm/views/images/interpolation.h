/// An image between its pixels, with the derivative of that very interpolant.
#pragma once

#include "tm/views/images/gray_image.h"

namespace transformesh {

enum class Interpolation {
  bilinear,     ///< continuous
  catmull_rom,  ///< continuous with its first derivative
};

struct Sample {
  float level = 0;
  float slope = 0;  ///< derivative in the direction asked for
};

/// `margin` pixels are needed to the left of and above the pixel that a place is in, and one more
/// to the right and below.
template <Interpolation interpolation>
inline constexpr int margin = interpolation == Interpolation::catmull_rom ? 1 : 0;

/// The image at pixel (column, row) plus (s, t), both in [0, 1), and its derivative in direction
/// (along_x, along_y). See bilinear_sample.h and cubic_sample.h.
template <Interpolation interpolation>
Sample sample(const GrayImage& image, int column, int row, float s, float t, float along_x,
              float along_y);

}  // namespace transformesh
