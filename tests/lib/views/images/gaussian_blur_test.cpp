#include "views/images/gaussian_blur.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/random.h"
#include "transformesh/image.h"

using namespace transformesh;

namespace {

GrayImage noise(int width, int height) {
  test::Random random(9);
  GrayImage image(width, height);
  for (float& intensity : image.pixels) intensity = static_cast<float>(random.below(256));
  return image;
}

int mirrored(int i, int count) {
  while (count > 1 && (i < 0 || i >= count)) i = i < 0 ? -i : 2 * (count - 1) - i;
  return count > 1 ? i : 0;
}

/// Returns the two-dimensional convolution by its definition, in double precision.
double blurred(const GrayImage& image, double deviation, int x, int y) {
  const int reach = static_cast<int>(std::lrint(8 * deviation + 1)) / 2;
  double sum = 0;
  double weights = 0;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      const double weight = std::exp(-(i * i + j * j) / (2 * deviation * deviation));
      const float intensity = image.at(mirrored(x + j, image.width), mirrored(y + i, image.height));
      sum += weight * static_cast<double>(intensity);
      weights += weight;
    }
  }
  return sum / weights;
}

}  // namespace

TEST_CASE("a blur is the mean under the Gaussian, mirrored at the borders") {
  for (const double deviation : {0.3, 0.8, 1.5, 4.0}) {
    for (const auto& [width, height] : {std::pair{37, 23}, {16, 1}, {1, 9}, {3, 2}, {49, 33}}) {
      CAPTURE(deviation);
      CAPTURE(width);
      const GrayImage image = noise(width, height);
      const GrayImage result = gaussian_blur(image, deviation);
      REQUIRE(result.width == width);
      REQUIRE(result.height == height);
      double worst = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          worst = std::max(worst, std::abs(static_cast<double>(result.at(x, y)) -
                                           blurred(image, deviation, x, y)));
      CHECK(worst < 1e-4);
    }
  }
}

TEST_CASE("sums are rounded to floats one product after the other") {
  // Rounding is that of fused multiply-adds, from left to right in each row, and then outwards from
  // the middle row.
  const GrayImage image = noise(40, 30);
  const double deviation = 1.5;
  std::vector<float> weights;
  double sum = 0;
  for (int i = -6; i <= 6; ++i) sum += std::exp(-i * i / (2 * deviation * deviation));
  for (int i = -6; i <= 6; ++i)
    weights.push_back(static_cast<float>(std::exp(-i * i / (2 * deviation * deviation)) / sum));
  const auto across = [&](int x, int y) {
    float intensity = 0;
    for (int i = 0; i < 13; ++i)
      intensity = std::fma(weights[static_cast<std::size_t>(i)],
                           image.at(mirrored(x + i - 6, 40), y), intensity);
    return intensity;
  };
  const GrayImage result = gaussian_blur(image, deviation);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      float intensity = weights[6] * across(x, y);
      for (int i = 1; i <= 6; ++i)
        intensity =
            std::fma(weights[static_cast<std::size_t>(6 + i)],
                     across(x, mirrored(y + i, 30)) + across(x, mirrored(y - i, 30)), intensity);
      CHECK(result.at(x, y) == intensity);
    }
  }
}
