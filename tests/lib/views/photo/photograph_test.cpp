#include "views/photo/photograph.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/intensities.h"
#include "helpers/view_maker.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/shapes.h"
#include "views/cameras/view.h"

using namespace transformesh;
using namespace view_maker;

namespace {

const Frame frame{80, 60, 300};
const Vec3 eye(0, -10, 0);

Camera test_camera() { return {camera_at(eye, frame).projection(), frame.width, frame.height}; }

const Mesh& ball() {
  static const Mesh mesh = make_sphere(Vec3::Zero(), 0.8, 80000);
  return mesh;
}

SolidTexture coarse_texture() { return SolidTexture({.waves = 20, .finest = 0.5, .coarsest = 2}); }

struct Moments {
  double mean = 0, deviation = 0;
};

template <typename Value>
Moments moments(int width, int height, const Value& value) {
  double sum = 0, squares = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      sum += value(x, y);
      squares += value(x, y) * value(x, y);
    }
  const double count = width * height;
  return {sum / count, std::sqrt(squares / count - sum * sum / (count * count))};
}

}  // namespace

TEST_CASE("a pixel shows the texture where its ray meets the surface") {
  const SolidTexture texture = coarse_texture();
  const PinholeCamera camera = camera_at(eye, frame);
  const Photograph photograph = take_photograph(ball(), test_camera(), texture, 0, {.noise = 0});
  int inside = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      // The nearer root of |eye + t ray| = 0.8.
      const Vec3 ray = camera.ray(x, y).normalized();
      const double half = -eye.dot(ray);
      const double square = half * half - eye.squaredNorm() + 0.64;
      if (square < -0.1) CHECK(photograph.image.at(x, y) == 0);
      if (square < 0.1) continue;
      ++inside;
      const Vec3 hit = eye + (half - std::sqrt(square)) * ray;
      CHECK(std::abs(photograph.image.at(x, y) - texture.intensity_at(hit)) < 3);
      CHECK(photograph.silhouette.at(x, y) == 255);
    }
  }
  CHECK(inside > 1000);
}

TEST_CASE("silhouettes are those of the ball") {
  const Photograph photograph =
      take_photograph(ball(), test_camera(), coarse_texture(), 0, {.noise = 0});
  const View exact = ball_view(eye, Vec3::Zero(), 0.8, frame);
  int different = 0;
  const std::vector<float> intensities = test::intensities_of(exact.silhouette);
  for (std::size_t i = 0; i < intensities.size(); ++i)
    different += (intensities[i] > 127.5F) != (photograph.silhouette.pixels[i] > 0);
  CHECK(different < 8);  // out of 150 pixels on the contour
}

TEST_CASE("noise has its deviation, differs between photographs and not between runs") {
  const SolidTexture texture = coarse_texture();
  const auto photograph = [&](std::uint64_t number, double noise) {
    return take_photograph(ball(), test_camera(), texture, number, {.noise = noise}).image;
  };
  const GrayImage clean = photograph(3, 0);
  const GrayImage noisy = photograph(3, 5);
  const Moments noise = moments(
      20, 20, [&](int x, int y) { return noisy.at(30 + x, 20 + y) - clean.at(30 + x, 20 + y); });
  CHECK(std::abs(noise.mean) < 0.8);
  CHECK(noise.deviation == doctest::Approx(5).epsilon(0.12));
  CHECK(photograph(3, 5).pixels == noisy.pixels);
  CHECK(photograph(4, 5).pixels != noisy.pixels);
  CHECK(photograph(4, 0).pixels == clean.pixels);
  const ThreadLimit one(1);
  CHECK(photograph(3, 5).pixels == noisy.pixels);
}

TEST_CASE("gain and offset are one affine map an image") {
  const SolidTexture texture = coarse_texture();
  const GrayImage plain = take_photograph(ball(), test_camera(), texture, 0, {.noise = 0}).image;
  bool is_different = false;
  double first_gain = 0;
  for (std::uint64_t number = 0; number < 4; ++number) {
    const GrayImage image = take_photograph(ball(), test_camera(), texture, number,
                                            {.noise = 0, .gain_spread = 0.2, .offset_spread = 10})
                                .image;
    // Fits gain and offset by least squares over the middle of the ball.
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int y = 20; y < 40; ++y)
      for (int x = 30; x < 50; ++x) {
        const double a = plain.at(x, y), b = image.at(x, y);
        n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
      }
    const double gain = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    const double offset = (sy - gain * sx) / n;
    CHECK(std::abs(gain - 1) < 0.21);
    CHECK(std::abs(offset) < 11);
    for (int y = 20; y < 40; ++y)
      for (int x = 30; x < 50; ++x)
        CHECK(std::abs(image.at(x, y) - gain * plain.at(x, y) - offset) < 1.5);
    if (number == 0) first_gain = gain;
    is_different = is_different || std::abs(gain - first_gain) > 0.02;
  }
  CHECK(is_different);
}

TEST_CASE("a texture varies as fast as asked for, and as much") {
  const SolidTexture fine({.waves = 100, .finest = 0.1, .coarsest = 0.2});
  const Moments intensities = moments(200, 200, [&](int x, int y) {
    return fine.intensity_at({0.037 * x, 0.041 * y, 0});
  });
  CHECK(intensities.mean == doctest::Approx(128).epsilon(0.05));
  CHECK(intensities.deviation == doctest::Approx(40).epsilon(0.15));
  // The texture hardly changes over steps far below the shortest wavelength, but it changes over
  // half a wavelength.
  const auto change = [&](double step) {
    return moments(100, 100,
                   [&](int x, int y) {
                     const Vec3 place(0.037 * x, 0.041 * y, 0.3);
                     return fine.intensity_at(place + Vec3(step, 0, 0)) - fine.intensity_at(place);
                   })
        .deviation;
  };
  CHECK(change(0.002) < 6);
  CHECK(change(0.05) > 30);
}

TEST_CASE("senseless options are refused") {
  const SolidTexture texture = coarse_texture();
  CHECK_THROWS_AS(take_photograph(ball(), test_camera(), texture, 0, {.samples = 0}), UsageError);
  CHECK_THROWS_AS(take_photograph(ball(), test_camera(), texture, 0, {.noise = -1}), UsageError);
  CHECK_THROWS_AS(take_photograph(ball(), test_camera(), texture, 0, {.gain_spread = 1}),
                  UsageError);
  CHECK_THROWS_AS(SolidTexture({.waves = 0}), UsageError);
  CHECK_THROWS_AS(SolidTexture({.finest = 0}), UsageError);
  CHECK_THROWS_AS(SolidTexture({.finest = 1, .coarsest = 0.5}), UsageError);
}
