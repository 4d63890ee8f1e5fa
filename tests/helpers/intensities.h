/// Reads and changes the pixels of views' images, which may be packed.
#pragma once

#include "views/images/packable_image.h"

namespace transformesh::test {

inline std::vector<float> intensities_of(const PackableImage& image) {
  return image.unpacked().pixels;
}

/// Replaces every intensity by the result of `change`.
template <class Change>
void change_intensities(PackableImage& image, const Change& change) {
  GrayImage plain = image.unpacked();
  for (float& intensity : plain.pixels) intensity = change(intensity);
  image = std::move(plain);
}

}  // namespace transformesh::test
