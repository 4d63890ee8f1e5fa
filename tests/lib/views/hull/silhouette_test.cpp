#include "views/hull/silhouette.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "helpers/disc_mask.h"
#include "helpers/random.h"
#include "transformesh/errors.h"
#include "views/hull/contour_distance.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("a threshold finds the contour between pixels") {
  // A bright disc with a contour as soft as a camera's. Its intensity is 60 at a known radius.
  GrayImage photograph(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      photograph.at(x, y) = static_cast<float>(std::clamp(60 - 30 * disc(x, y), 0.0, 200.0));
  const GrayImage distances = signed_distance(threshold_silhouette(photograph, {60, 0, 0}));
  CHECK(worst_error(distances, disc) < 0.1);
  const GrayImage lower = signed_distance(threshold_silhouette(photograph, {30, 0, 0}));
  CHECK(worst_error(lower, [](double x, double y) { return disc(x, y) - 1; }) < 0.1);
}

TEST_CASE("blurring removes single bright pixels") {
  GrayImage photograph = soft_mask(disc);
  photograph.at(60, 5) = 255;
  CHECK(threshold_silhouette(photograph, {100, 0, 0}).at(60, 5) > 127.5F);
  CHECK(threshold_silhouette(photograph, {100, 1.5, 0}).at(60, 5) < 127.5F);
  CHECK(inside_share(photograph) ==
        doctest::Approx(3.14159 * 11.7 * 11.7 / (width * height)).epsilon(0.02));
}

TEST_CASE("without an intensity, that between dark and bright pixels is found") {
  // Intensities around 40 and around 180, both with some spread.
  GrayImage photograph(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      photograph.at(x, y) = static_cast<float>((disc(x, y) < 0 ? 180 : 40) + (7 * x + 3 * y) % 31);
  const GrayImage mask = binary_silhouette(threshold_silhouette(photograph, {std::nullopt, 0, 0}));
  CHECK(mask.pixels == binary_silhouette(soft_mask(disc)).pixels);
}

TEST_CASE("the dividing intensity leaves the largest variance between dark and bright") {
  Random random(6);
  for (int round = 0; round < 50; ++round) {
    // Two clusters of intensities, and others anywhere.
    std::array<GrayImage, 2> images{GrayImage(30, 20), GrayImage(17, 9)};
    const double dark = random.uniform(0, 120);
    const double bright = random.uniform(130, 250);
    for (GrayImage& image : images) {
      for (float& intensity : image.pixels) {
        const std::uint64_t heap = random.below(5);
        const double middle = heap == 0 ? random.uniform(0, 255) : heap < 3 ? dark : bright;
        intensity = std::clamp(static_cast<float>(std::round(middle + random.uniform(-9, 9))), 0.0F,
                               255.0F);
      }
    }
    const auto variance_at = [&](double intensity) {
      std::array<double, 2> counts{};
      std::array<double, 2> sums{};
      for (const GrayImage& image : images) {
        for (const float pixel : image.pixels) {
          const std::size_t side = static_cast<double>(pixel) > intensity ? 1 : 0;
          ++counts[side];
          sums[side] += static_cast<double>(pixel);
        }
      }
      if (counts[0] == 0 || counts[1] == 0) return 0.0;
      return counts[0] * counts[1] * std::pow(sums[1] / counts[1] - sums[0] / counts[0], 2);
    };
    const double found = variance_at(dividing_threshold(images));
    for (int intensity = 0; intensity < 255; ++intensity)
      CHECK(variance_at(intensity + 0.5) <= found * (1 + 1e-9));
  }
}

TEST_CASE("the dividing intensity lies in the middle of the intensities that no pixel has") {
  GrayImage image(4, 1);
  image.pixels = {10, 10, 20, 90};
  CHECK(dividing_threshold({&image, 1}) == 55);
  image.pixels = {0, 0, 0, 255};
  CHECK(dividing_threshold({&image, 1}) == 127.5);
  image.pixels = {7, 7, 7, 7};
  CHECK(dividing_threshold({&image, 1}) == doctest::Approx(3.5));
  CHECK(dividing_threshold({}) == 127.5);
}

TEST_CASE("dark marks on the object become part of it, wide gaps do not") {
  // A wide bar that leaves the image, with a dark line, a notch and a wide hole in it.
  GrayImage photograph(width, height);
  const auto fill = [&](int left, int top, int right, int bottom, float intensity) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) photograph.at(x, y) = intensity;
  };
  fill(0, 5, 50, 43, 200);
  const GrayImage unmarked = photograph;
  fill(10, 12, 40, 14, 0);
  fill(5, 20, 20, 35, 0);
  const GrayImage closed =
      binary_silhouette(threshold_silhouette(photograph, {100, 0, 0.05}));  // 3.2
  CHECK(closed.at(20, 12) == 255);
  CHECK(closed.at(12, 27) == 0);
  // Pixels outside stay outside, also where the bar leaves the image.
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (unmarked.at(x, y) == 0) CHECK(closed.at(x, y) == 0);
  for (int y = 5; y < 11; ++y) CHECK(closed.at(0, y) == 255);
}

TEST_CASE("options that make no sense are refused") {
  const GrayImage image(4, 4);
  CHECK_THROWS_AS(threshold_silhouette(image, {0, 1, 0}), UsageError);
  CHECK_THROWS_AS(threshold_silhouette(image, {255, 1, 0}), UsageError);
  CHECK_THROWS_AS(threshold_silhouette(image, {25, -1, 0}), UsageError);
  CHECK_THROWS_AS(threshold_silhouette(image, {25, 1, -0.1}), UsageError);
  CHECK(signed_distance(GrayImage()).empty());
  CHECK(threshold_silhouette(GrayImage()).empty());
}

TEST_CASE("agreement is intersection over union") {
  GrayImage left(10, 10);
  GrayImage right(10, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 6; ++x) left.at(x, y) = 255;
    for (int x = 4; x < 10; ++x) right.at(x, y) = 255;
  }
  CHECK(silhouette_agreement(left, right) == doctest::Approx(0.2));
  CHECK(silhouette_agreement(left, left) == 1);
  CHECK(silhouette_agreement(GrayImage(3, 3), GrayImage(3, 3)) == 1);
  CHECK_THROWS_AS(silhouette_agreement(left, GrayImage(10, 9)), UsageError);
}
