#include "views/images/compressed_tiles.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/random.h"

using namespace transformesh;

namespace {

using Words = Raster<std::uint16_t>;

/// Returns words that are a function of the pixel.
template <class Function>
Words made(int width, int height, const Function& function) {
  Words words(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) words.at(x, y) = static_cast<std::uint16_t>(function(x, y));
  return words;
}

/// Returns the bytes per pixel. Checks that every word is decoded correctly.
double bytes_per_pixel(const Words& words) {
  const CompressedTiles tiled(words);
  int different = 0;
  for (int y = 0; y < words.height; ++y)
    for (int x = 0; x < words.width; ++x) different += tiled.at(x, y) != words.at(x, y);
  CHECK(different == 0);
  std::vector<std::uint16_t> all;
  tiled.copy_to(all);
  CHECK(all == words.pixels);
  return static_cast<double>(tiled.size()) / static_cast<double>(words.pixels.size());
}

}  // namespace

TEST_CASE("pixels of a smooth image take half a byte, and random ones their full size") {
  const auto from = [](double place_x, double place_y) {
    return [=](int x, int y) { return 64 * std::hypot(x - place_x, y - place_y); };
  };
  CHECK(bytes_per_pixel(made(400, 296, from(-400, -300))) < 0.8);
  CHECK(bytes_per_pixel(made(400, 296, from(200, 150))) < 1);
  CHECK(bytes_per_pixel(made(400, 296, [](int x, int y) { return 5 * x + 3 * y; })) < 0.2);
  Random random(1);
  const auto noise = [&](int /*x*/, int /*y*/) { return random.uniform(0, 65536); };
  const double most = bytes_per_pixel(made(400, 296, noise));
  CHECK(most > 2);
  CHECK(most < 2.2);
}

TEST_CASE("words of any size of image, up to the ends of their range") {
  for (const int width : {1, 7, 8, 9, 17})
    for (const int height : {1, 8, 13}) {
      bytes_per_pixel(made(width, height, [](int /*x*/, int /*y*/) { return 65535; }));
      bytes_per_pixel(made(width, height, [](int x, int y) { return (x + y) % 2 * 65535; }));
      bytes_per_pixel(made(width, height, [](int x, int y) { return 60000 - 900 * x - 11 * y; }));
      // The largest numbers of four and of eight bits, and the next larger ones.
      for (const int step : {7, 8, 9, 127, 128, 129}) {
        bytes_per_pixel(made(width, height, [&](int x, int y) {
          return 1000 + (x == 3 && y == 5 ? step : 0) - (x == 4 && y == 6 ? step : 0);
        }));
      }
    }
}
