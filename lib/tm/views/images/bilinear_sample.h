/// Levels between four pixels, linear in each direction.
#pragma once

#include "tm/views/images/interpolation.h"

namespace transformesh {

template <>
inline Sample sample<Interpolation::bilinear>(const GrayImage& image, int column, int row, float s,
                                              float t, float along_x, float along_y) {
  const float* top = image.row(row) + column;
  const float* bottom = top + image.width;
  const float top_step = top[1] - top[0];
  const float bottom_step = bottom[1] - bottom[0];
  const float top_level = top[0] + s * top_step;
  const float down = bottom[0] + s * bottom_step - top_level;
  return {top_level + t * down,
          along_x * (top_step + t * (bottom_step - top_step)) + along_y * down};
}

}  // namespace transformesh
