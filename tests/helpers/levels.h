/// Images of views as plain ones, to be read and changed pixel by pixel.
#pragma once

#include "views/images/held_image.h"

namespace transformesh::test {

inline std::vector<float> levels_of(const HeldImage& image) { return image.unpacked().pixels; }

/// Every level becomes what `change` makes of it.
template <class Change>
void change_levels(HeldImage& image, const Change& change) {
  GrayImage plain = image.unpacked();
  for (float& level : plain.pixels) level = change(level);
  image = std::move(plain);
}

}  // namespace transformesh::test
