#include <doctest/doctest.h>
#include <png.h>

#include "helpers/random.h"
#include "transformesh/errors.h"
#include "transformesh/image.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Decodes the bytes by libpng as RGBA.
Image decoded(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) != 0);
  header.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  REQUIRE(png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr) != 0);
  return image;
}

Image noise(int width, int height, bool is_opaque) {
  Random random(5);
  Image image(width, height);
  for (Pixel& pixel : image.pixels)
    for (std::size_t i = 0; i < 4; ++i)
      pixel[i] = i == 3 && is_opaque ? 255 : static_cast<std::uint8_t>(random.below(256));
  return image;
}

constexpr std::size_t color_type_offset = 25;

}  // namespace

TEST_CASE("a PNG decodes to the pixels it was made of") {
  for (const bool is_opaque : {true, false})
    for (const int width : {1, 7, 64}) {
      const Image image = noise(width, 13, is_opaque);
      const std::string bytes = write_png(image);
      CHECK(bytes.substr(1, 3) == "PNG");
      CHECK(bytes[color_type_offset] == (is_opaque ? 2 : 6));
      const Image read = decoded(bytes);
      CHECK(read.width == width);
      CHECK(read.height == 13);
      CHECK(read.pixels == image.pixels);
      CHECK(write_png(image) == bytes);
    }
}

TEST_CASE("an image without pixels is refused") {
  CHECK_THROWS_AS(write_png(Image{}), UsageError);
  CHECK_THROWS_AS(write_png(Image(5, 0)), UsageError);
}
