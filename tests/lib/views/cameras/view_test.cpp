#include "views/cameras/view.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers/intensities.h"
#include "transformesh/errors.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Returns an image of a sine wave with a wavelength of `length` pixels.
GrayImage wave(int width, int height, double length) {
  GrayImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      image.at(x, y) = static_cast<float>(100 + 50 * std::cos(2 * std::numbers::pi * x / length));
  }
  return image;
}

}  // namespace

TEST_CASE("every pixel of a linear image is where the smaller camera says") {
  // Blurs and means preserve linear functions, except at borders.
  for (const double scale : {1.0, std::sqrt(2.0), 2.0, 3.7}) {
    View view{"", {}, GrayImage(90, 70), {}};
    view.camera.intrinsics << 80, 0, 44, 0, 90, 36, 0, 0, 1;
    for (int y = 0; y < 70; ++y) {
      for (int x = 0; x < 90; ++x) view.image.at(x, y) = static_cast<float>(20 + 1.5 * x + 0.5 * y);
    }
    const View small = at_scale(view, scale);
    CHECK(small.image.width == static_cast<int>(90 / scale));
    CHECK(small.image.height == static_cast<int>(70 / scale));
    const int border = static_cast<int>(std::ceil(0.45 * 3 + 2));
    for (int y = border; y < small.image.height - border; ++y) {
      for (int x = border; x < small.image.width - border; ++x) {
        const Vec3 q = view.camera.projection() * Vec3(small.camera.ray(x, y)).homogeneous();
        const double expected = 20 + 1.5 * q.x() / q.z() + 0.5 * q.y() / q.z();
        // The Gaussian is truncated at three standard deviations.
        CHECK(std::abs(small.image.at(x, y) - expected) < 1e-2);
      }
    }
  }
}

TEST_CASE("a wave is damped by the Gaussian and the area of the pixels") {
  const double scale = 2;
  const double length = 12;
  const GrayImage small = at_scale(wave(240, 30, length), scale);
  const double frequency = 2 * std::numbers::pi / length;
  const double by_blur = std::exp(-0.5 * std::pow(0.45 * scale * frequency, 2));
  const double by_area = std::sin(frequency * scale / 2) / (frequency * scale / 2);
  for (int x = 10; x < 110; ++x) {
    const double place = (x + 0.5) * scale - 0.5;
    CHECK(small.at(x, 7) ==
          Approx(100 + 50 * by_blur * by_area * std::cos(frequency * place)).epsilon(2e-3));
  }
}

TEST_CASE("silhouettes are averaged, and constant images stay so up to the border") {
  View view{"", {}, GrayImage(40, 40, 77), GrayImage(40, 40, 0)};
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 21; ++x) view.silhouette.at(x, y) = 255;
  }
  const View half = at_scale(view, 2);
  for (const float intensity : test::intensities_of(half.image))
    CHECK(intensity == Approx(77).epsilon(1e-5));
  CHECK(half.silhouette.at(7, 5) == Approx(255));
  CHECK(half.silhouette.at(10, 5) == Approx(127.5).epsilon(1e-4));
  CHECK(half.silhouette.at(13, 5) == Approx(0));
  CHECK(test::intensities_of(at_scale(view, 1).silhouette) ==
        test::intensities_of(view.silhouette));
}

TEST_CASE("scales without an image are refused") {
  CHECK_THROWS_AS(at_scale(GrayImage(10, 10), 0.5), UsageError);
  CHECK_THROWS_AS(at_scale(GrayImage(10, 10), 10.5), UsageError);
  CHECK_THROWS_AS(at_scale(GrayImage(10, 10), NAN), UsageError);
  CHECK(at_scale(GrayImage(10, 10, 3), 10).pixels == std::vector<float>{3});
}
