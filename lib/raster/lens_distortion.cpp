#include "raster/lens_distortion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/parallel.h"

namespace transformesh {
namespace {

/// Returns the intensity at `place`, by bilinear interpolation. At most half a pixel outside of the
/// pixel centers, the nearest pixel of the border counts; farther outside, the result is 0.
float intensity_at(const GrayImage& image, const Eigen::Vector2d& place) {
  const double right = image.width - 1;
  const double bottom = image.height - 1;
  const bool is_seen = place.x() >= -0.5 && place.y() >= -0.5 && place.x() <= right + 0.5 &&
                       place.y() <= bottom + 0.5;
  if (!is_seen) return 0;
  const double x = std::clamp(place.x(), 0.0, right);
  const double y = std::clamp(place.y(), 0.0, bottom);
  const int column = std::min(static_cast<int>(x), std::max(0, image.width - 2));
  const int row = std::min(static_cast<int>(y), std::max(0, image.height - 2));
  const int next_column = std::min(column + 1, image.width - 1);
  const int next_row = std::min(row + 1, image.height - 1);
  const auto s = static_cast<float>(x - column);
  const auto t = static_cast<float>(y - row);
  const float top = image.at(column, row) * (1 - s) + image.at(next_column, row) * s;
  const float low = image.at(column, next_row) * (1 - s) + image.at(next_column, next_row) * s;
  return top * (1 - t) + low * t;
}

}  // namespace

Eigen::Vector2d LensDistortion::distorted(double x, double y) const {
  const auto& k = radial;
  const double r2 = x * x + y * y;
  const double factor =
      (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[2]))) / (1 + r2 * (k[3] + r2 * (k[4] + r2 * k[5])));
  const auto& [p1, p2] = tangential;
  return {x * factor + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
          y * factor + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

GrayImage undistorted(const GrayImage& image, const Eigen::Matrix3d& intrinsics,
                      const LensDistortion& distortion) {
  if (distortion.is_none()) return image;
  GrayImage result(image.width, image.height);
  const Eigen::Matrix3d inverse = intrinsics.inverse();
  parallel_for(static_cast<std::size_t>(image.height), 16,
               [&](std::size_t first, std::size_t last) {
                 for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
                   for (int x = 0; x < image.width; ++x) {
                     const Eigen::Vector3d ray = inverse * Eigen::Vector3d(x, y, 1);
                     const Eigen::Vector2d bent = distortion.distorted(ray.x(), ray.y());
                     const Eigen::Vector3d place = intrinsics * bent.homogeneous();
                     result.at(x, y) = intensity_at(image, place.head<2>());
                   }
                 }
               });
  return result;
}

Image undistorted(const Image& image, const Eigen::Matrix3d& intrinsics,
                  const LensDistortion& distortion) {
  if (distortion.is_none()) return image;
  Image result(image.width, image.height, Pixel{0, 0, 0, 255});
  GrayImage channel(image.width, image.height);
  for (std::size_t c = 0; c < 3; ++c) {
    std::transform(image.pixels.begin(), image.pixels.end(), channel.pixels.begin(),
                   [c](const Pixel& pixel) { return static_cast<float>(pixel[c]); });
    const GrayImage straight = undistorted(channel, intrinsics, distortion);
    for (std::size_t i = 0; i < result.pixels.size(); ++i)
      result.pixels[i][c] = static_cast<std::uint8_t>(straight.pixels[i] + 0.5F);
  }
  return result;
}

}  // namespace transformesh
