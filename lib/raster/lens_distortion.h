/// Lens distortion, and its removal from images.
/// Reference: Brown, "Decentering distortion of lenses", Photogrammetric Engineering 32 (1966),
/// with the parameters of OpenCV's and COLMAP's models.
#pragma once

#include <Eigen/Core>
#include <array>

#include "transformesh/image.h"

namespace transformesh {

struct LensDistortion {
  /// Radial distortion scales the point (x, y) of the ray (x, y, 1), at distance r from the axis.
  /// The factor is `(1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)`.
  std::array<double, 6> radial{};
  /// Tangential distortion adds 2 p1 x y + p2 (r^2 + 2 x^2) to x, and p1 (r^2 + 2 y^2) + 2 p2 x y
  /// to y.
  std::array<double, 2> tangential{};

  bool operator==(const LensDistortion&) const = default;
  bool is_none() const { return *this == LensDistortion(); }
  /// Returns the distorted position of the point (x, y) of the undistorted ray (x, y, 1).
  Eigen::Vector2d distorted(double x, double y) const;
};

/// Resamples the image as a pinhole camera with the same intrinsics would have recorded it. The
/// last row of `intrinsics` must be 0 0 1. Interpolates bilinearly; pixels outside of the original
/// image are 0. The size does not change. O(pixels), parallel.
GrayImage undistorted(const GrayImage& image, const Eigen::Matrix3d& intrinsics,
                      const LensDistortion& distortion);
/// Undistorts each color channel like a gray image.
Image undistorted(const Image& image, const Eigen::Matrix3d& intrinsics,
                  const LensDistortion& distortion);

}  // namespace transformesh
