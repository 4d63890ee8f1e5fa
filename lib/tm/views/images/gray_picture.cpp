#include "tm/views/images/gray_picture.h"

#include <algorithm>
#include <cmath>

namespace transformesh {

Image picture_of(const GrayImage& image) {
  Image picture(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float level = std::clamp(std::round(image.pixels[i]), 0.0F, 255.0F);
    const auto byte = static_cast<std::uint8_t>(level);
    picture.pixels[i] = {byte, byte, byte, 255};
  }
  return picture;
}

}  // namespace transformesh
