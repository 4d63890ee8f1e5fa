#include "views/images/image_file.h"

#include <doctest/doctest.h>

#include <array>

#include "helpers/encoded_images.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;
using namespace std::string_literals;

TEST_CASE("the format is detected by the first bytes") {
  const Rows rows = noise(6);
  const std::array images{jpeg_of({1}, 3, 2, rows), png_of({0, 8}, 3, 2, rows),
                          tiff_of({}, 3, 2, rows), "P2 3 2 9 1 2 3 4 5 6"s};
  for (const std::string& bytes : images) {
    CHECK(is_image(bytes.substr(0, 16)));
    CHECK(decode_photograph(bytes, "a.image").pixels.size() == 6);
  }
  CHECK(!is_image("ply\nformat ascii 1.0"));
  CHECK(!is_image(""));
}

TEST_CASE("the size is known without the pixels") {
  const Rows rows = noise(3 * 60 * 40);
  const Rows gray = noise(60 * 40);
  const std::array images{jpeg_of({3}, 60, 40, rows),
                          jpeg_of({3, true}, 60, 40, rows),
                          png_of({0, 8}, 60, 40, gray),
                          png_of({2, 8, true}, 60, 40, rows),
                          tiff_of({8, 3, 2}, 60, 40, rows),
                          "P6 60 40 255\n" + std::string(7200, 'x'),
                          "P2 60 40 9" + std::string(2400, '\n') + "no sample"};
  for (const std::string& bytes : images) {
    const GrayImage size = decode_size(bytes, "a.image");
    CHECK(size.width == 60);
    CHECK(size.height == 40);
    CHECK(size.pixels.empty());
  }
  // The pixels need not be complete.
  CHECK(decode_size(images[0].substr(0, images[0].size() - 100), "a.image").width == 60);
  CHECK(decode_size(images[2].substr(0, images[2].size() - 100), "a.image").width == 60);
  CHECK_THROWS_AS(decode_size("", "a.image"), InputError);
}

TEST_CASE("an image of another format is refused with the way to convert it") {
  const std::array<std::array<std::string, 2>, 6> others{
      {{"BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0"s, "BMP"},
       {"RIFF\x24\0\0\0WEBPVP8 "s, "WebP"},
       {"GIF89a\x01\0\x01\0"s, "GIF"},
       {"\0\0\0\x18"
        "ftypheic\0\0\0\0"s,
        "HEIF"},
       {"\0\0\0\x0cjP  \r\n\x87\n"s, "JPEG 2000"},
       {"v/1\x01\x02\0\0\0"s, "OpenEXR"}}};
  for (const auto& [bytes, format] : others) {
    CHECK(is_image(bytes));
    CHECK(image_refusal(bytes) ==
          "the format is " + format +
              "; only JPEG, PNG, TIFF and PNM of 8 or 16 bits are read: convert "
              "it first, for example with: magick a.image a.png (a.image)");
  }
}

TEST_CASE("files that are no images are refused with their first bytes") {
  CHECK(image_refusal("").find("empty") != std::string::npos);
  CHECK(image_refusal("hello, world").find("'hello, world'") != std::string::npos);
}

TEST_CASE("pixels with any sample above zero are inside a silhouette") {
  const GrayImage deep = decode_mask(std::string("P5 2 1 65535\n\0\1\0\0", 17), "a.pgm").silhouette;
  CHECK(deep.at(0, 0) == 255);
  CHECK(deep.at(1, 0) == 0);
  const GrayImage color = decode_mask("P3 2 1 255 0 0 1 0 0 0", "a.ppm").silhouette;
  CHECK(color.at(0, 0) == 255);
  CHECK(color.at(1, 0) == 0);
  // Transparency is the mask if it varies, and is ignored if it does not.
  const Mask cut_out = decode_mask(png_of({4, 8}, 2, 1, {0, 255, 9, 0}), "a.png");
  CHECK(cut_out.rule == MaskRule::alpha);
  CHECK(cut_out.silhouette.at(0, 0) == 255);
  CHECK(cut_out.silhouette.at(1, 0) == 0);
  const GrayImage opaque = decode_mask(png_of({4, 8}, 2, 1, {0, 255, 9, 255}), "a.png").silhouette;
  CHECK(opaque.at(0, 0) == 0);
  CHECK(opaque.at(1, 0) == 255);
}
