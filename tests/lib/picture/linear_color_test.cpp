#include "picture/linear_color.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace transformesh;

TEST_CASE("sRGB has the values of its standard") {
  CHECK(light_of_srgb(0) == 0);
  CHECK(light_of_srgb(1) == 1);
  CHECK(std::abs(light_of_srgb(0.5) - 0.2140411F) < 1e-6F);
  CHECK(std::abs(light_of_srgb(0.04) - 0.04F / 12.92F) < 1e-8F);
  CHECK(light_of_srgb(-1) == 0);
  CHECK(light_of_srgb(7) == 1);
}

TEST_CASE("each of the 256 bytes comes back from its light") {
  for (int byte = 0; byte < 256; ++byte) CHECK(srgb_byte(light_of_srgb(byte / 255.0)) == byte);
  CHECK(srgb_byte(-1) == 0);
  CHECK(srgb_byte(2) == 255);
}

TEST_CASE("bytes are the nearest value of the exact curve") {
  for (int i = 0; i <= 10000; ++i) {
    const float light = static_cast<float>(i) / 10000;
    CHECK(std::abs(255 * srgb_of_light(light) - srgb_byte(light)) < 0.56);
  }
}
