/// Images of views as plain ones, to be read and changed pixel by pixel.
#pragma once

#include "views/images/packable_image.h"

namespace transformesh::test {

inline std::vector<float> intensities_of(const PackableImage& image) {
  return image.unpacked().pixels;
}

/// Every intensity becomes what `change` makes of it.
template <class Change>
void change_intensities(PackableImage& image, const Change& change) {
  GrayImage plain = image.unpacked();
  for (float& intensity : plain.pixels) intensity = change(intensity);
  image = std::move(plain);
}

}  // namespace transformesh::test
