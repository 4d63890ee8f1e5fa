#include <doctest/doctest.h>
#include <png.h>

#include "helpers/encoded_images.h"
#include "views/images/image_file.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("PNG of every color type, depth and order of rows") {
  constexpr int width = 3;
  for (const bool is_interlaced : {false, true}) {
    CAPTURE(is_interlaced);
    const auto intensity = [&](int color_type, int depth, const Rows& row, int x) {
      Rows rows = row;
      rows.insert(rows.end(), row.begin(), row.end());
      const std::string bytes = png_of({color_type, depth, is_interlaced}, width, 2, rows);
      const GrayImage image = decode_photograph(bytes, "a.png");
      REQUIRE(image.width == width);
      REQUIRE(image.height == 2);
      REQUIRE(image.pixels.size() == 6);
      CHECK(image.at(x, 0) == image.at(x, 1));
      return static_cast<double>(image.at(x, 1));
    };
    CHECK(intensity(PNG_COLOR_TYPE_GRAY, 1, {0b01000000}, 1) == 255);
    CHECK(intensity(PNG_COLOR_TYPE_GRAY, 2, {0b00011000}, 2) == 170);
    CHECK(intensity(PNG_COLOR_TYPE_GRAY, 4, {0x0f, 0x30}, 2) == 51);
    CHECK(intensity(PNG_COLOR_TYPE_GRAY, 8, {1, 2, 77}, 2) == 77);
    CHECK(intensity(PNG_COLOR_TYPE_GRAY, 16, {0, 0, 0x12, 0x34, 0, 0}, 1) ==
          doctest::Approx(0x1234 / 257.0).epsilon(1e-7));
    CHECK(intensity(PNG_COLOR_TYPE_PALETTE, 1, {0b01000000}, 1) ==
          doctest::Approx(gray(200, 100, 50)).epsilon(1e-7));
    CHECK(intensity(PNG_COLOR_TYPE_RGB, 8, {0, 0, 0, 1, 2, 3, 9, 8, 7}, 1) ==
          doctest::Approx(gray(1, 2, 3)).epsilon(1e-7));
    CHECK(intensity(PNG_COLOR_TYPE_RGB_ALPHA, 8, {0, 0, 0, 0, 90, 60, 30, 0, 9, 8, 7, 0}, 1) ==
          doctest::Approx(gray(90, 60, 30)).epsilon(1e-7));
    CHECK(intensity(PNG_COLOR_TYPE_GRAY_ALPHA, 8, {0, 0, 90, 0, 9, 0}, 1) == 90);
  }
}

TEST_CASE("rows of a PNG stay in their order, interlaced or not") {
  const Rows rows = noise(13 * 9);
  for (const bool is_interlaced : {false, true}) {
    const std::string bytes = png_of({PNG_COLOR_TYPE_GRAY, 8, is_interlaced}, 13, 9, rows);
    CHECK(std::equal(rows.begin(), rows.end(), decode_photograph(bytes, "a.png").pixels.begin()));
  }
}

TEST_CASE("a PNG that is cut short is refused, and damage does no harm") {
  for (const bool is_interlaced : {false, true}) {
    CAPTURE(is_interlaced);
    const std::string bytes =
        png_of({PNG_COLOR_TYPE_RGB, 8, is_interlaced}, 7, 9, noise(7 * 9 * 3));
    check_beginnings(bytes);
    check_damage(bytes);
  }
}

TEST_CASE("a PNG that claims more pixels than its bytes can hold is refused") {
  std::string bytes = png_of({PNG_COLOR_TYPE_RGB, 8}, 1, 1, {1, 2, 3});
  // The width and its check sum, of 20000 x 20000.
  bytes.replace(16, 8, std::string("\0\0\x4e\x20\0\0\x4e\x20", 8));
  bytes.replace(29, 4, "\x6c\x12\xd1\x6e");
  CHECK(image_refusal(bytes).find("20000 x 20000 pixels cannot be stored in") != std::string::npos);
}
