/// What shows where the surface does not.
#pragma once

#include "tm/picture/color.h"

namespace transformesh {

struct Background {
  /// From the top row to the bottom row: a quiet light grey, #f7f7f7 to #d6d9de.
  Color top = color_of_srgb(0xf7 / 255.0, 0xf7 / 255.0, 0xf7 / 255.0);
  Color bottom = color_of_srgb(0xd6 / 255.0, 0xd9 / 255.0, 0xde / 255.0);
  bool is_transparent = false;

  Color at(int y, int height) const {
    const float share = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
    return top + share * (bottom - top);
  }
};

}  // namespace transformesh
