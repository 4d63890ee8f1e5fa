#include "raster/lens_distortion.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

using namespace transformesh;

namespace {

Eigen::Matrix3d intrinsics() {
  Eigen::Matrix3d k;
  k << 100, 0, 39.5, 0, 110, 29.5, 0, 0, 1;
  return k;
}

/// Returns the intensity of the world at (x, y, 1); smooth, so that interpolation is nearly exact.
float intensity(double x, double y) {
  return static_cast<float>(120 + 60 * std::sin(9 * x + 1) + 50 * std::cos(7 * y - 4 * x));
}

/// Returns the undistorted point that the lens shows at x, y, by fixed-point iteration without the
/// code under test.
Eigen::Vector2d before_lens(const LensDistortion& lens, const Eigen::Vector2d& bent) {
  Eigen::Vector2d point = bent;
  for (int i = 0; i < 100; ++i) point += bent - lens.distorted(point.x(), point.y());
  return point;
}

}  // namespace

TEST_CASE("distortion is that of the formulas, worked out by hand") {
  const LensDistortion none;
  CHECK(none.is_none());
  CHECK(none.distorted(0.3, -0.2) == Eigen::Vector2d(0.3, -0.2));
  const LensDistortion radial{{0.1, 0.2, 0, 0, 0, 0}, {}};
  // r^2 = 0.25: 1 + 0.025 + 0.0125.
  CHECK(radial.distorted(0.3, 0.4).isApprox(1.0375 * Eigen::Vector2d(0.3, 0.4), 1e-14));
  const LensDistortion rational{{0, 0, 0, 1, 0, 0}, {}};
  CHECK(rational.distorted(0.3, 0.4).isApprox(0.8 * Eigen::Vector2d(0.3, 0.4), 1e-14));
  const LensDistortion tangential{{}, {0.1, 0.2}};
  // x: 2 0.1 0.12 + 0.2 (0.25 + 0.18); y: 0.1 (0.25 + 0.32) + 2 0.2 0.12.
  CHECK(tangential.distorted(0.3, 0.4).isApprox(Eigen::Vector2d(0.41, 0.505), 1e-14));
}

TEST_CASE("an undistorted image is that of a pinhole camera") {
  const LensDistortion lens{{0.3, -0.1, 0, 0, 0, 0}, {0.01, -0.02}};
  const Eigen::Matrix3d k = intrinsics();
  GrayImage bent(80, 60);
  GrayImage straight(80, 60);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      const Eigen::Vector2d ray = (k.inverse() * Eigen::Vector3d(x, y, 1)).head<2>();
      straight.at(x, y) = intensity(ray.x(), ray.y());
      const Eigen::Vector2d seen = before_lens(lens, ray);
      bent.at(x, y) = intensity(seen.x(), seen.y());
    }
  }
  const GrayImage result = undistorted(bent, k, lens);
  double worst = 0;
  double worst_before = 0;
  for (int y = 8; y < 52; ++y) {
    for (int x = 8; x < 72; ++x) {
      worst = std::max<double>(worst, std::abs(result.at(x, y) - straight.at(x, y)));
      worst_before = std::max<double>(worst_before, std::abs(bent.at(x, y) - straight.at(x, y)));
    }
  }
  CHECK(worst < 0.5);
  CHECK(worst_before > 5);
  CHECK(undistorted(bent, k, {}).pixels == bent.pixels);
}
