/// What shows where the surface does not.
#pragma once

#include "tm/picture/color.h"

namespace transformesh {

struct Background {
  /// From the top row to the bottom row: a quiet light grey.
  Color top = color_of_srgb(0.97, 0.97, 0.97);
  Color bottom = color_of_srgb(0.84, 0.85, 0.87);
  bool is_transparent = false;

  Color at(int y, int height) const {
    const float share = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
    return top + share * (bottom - top);
  }
};

}  // namespace transformesh
