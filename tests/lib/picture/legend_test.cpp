#include "picture/legend.h"

#include <doctest/doctest.h>

#include <vector>

using namespace transformesh;

namespace {

const Pixel white{255, 255, 255, 255};

Background plain_white() {
  Background background;
  background.top = background.bottom = Color::Ones();
  return background;
}

Image legend_of(const ColorScale& scale, int width = 200, int height = 100) {
  Image image(width, height, white);
  draw_legend(scale, plain_white(), image);
  return image;
}

/// Counts the dark pixels, which are those of the numbers, in columns [first, last).
int ink(const Image& image, int first, int last) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = first; x < last; ++x) count += image.at(x, y) == Pixel{25, 25, 25, 255};
  return count;
}

}  // namespace

TEST_CASE("the bar has the colors of the ends, and numbers stand beside it") {
  const ColorScale scale{1, 8};
  const Image image = legend_of(scale);
  const int middle = image.height - legend_height(200, 100) / 2 - 1;
  CHECK(image.at(50, middle) == Pixel{68, 1, 84, 255});
  CHECK(image.at(149, middle) == Pixel{253, 231, 37, 255});
  // the dots of 1 and of 8 in this font
  CHECK(ink(image, 0, 50) == 10);
  CHECK(ink(image, 150, 200) == 17);
  // the row above the strip stays white
  for (int x = 0; x < 200; ++x) CHECK(image.at(x, 100 - legend_height(200, 100) - 1) == white);
}

TEST_CASE("other numbers look different, minus signs and exponents too") {
  const Image a = legend_of({-2, 1e-7}, 400, 100);
  const Image b = legend_of({2, 1e7}, 400, 100);
  const Image c = legend_of({-2, 1e7}, 400, 100);
  CHECK(a.pixels != c.pixels);
  CHECK(b.pixels != c.pixels);
  CHECK(ink(a, 300, 400) != ink(c, 300, 400));
}

TEST_CASE("numbers grow with the picture; small pictures have none, and nothing is out of bounds") {
  CHECK(legend_height(119, 500) == 0);
  CHECK(legend_height(500, 59) == 0);
  CHECK(legend_height(800, 600) == 2 * legend_height(200, 100));
  for (const int width : {1, 119, 120, 121, 150, 1000})
    for (const int height : {1, 59, 60, 61, 1000})
      CHECK_NOTHROW(legend_of({-1.234e-300, 1.234e300}, width, height));
}
