/// How a lens bends rays, and images without that.
/// Reference: Brown, "Decentering distortion of lenses", Photogrammetric Engineering 32 (1966),
/// with the parameters of OpenCV's and COLMAP's models.
#pragma once

#include <Eigen/Core>
#include <array>

#include "transformesh/image.h"

namespace transformesh {

struct LensDistortion {
  /// A point x, y of the ray x, y, 1, at distance r from the axis, moves by the factor
  /// (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6).
  std::array<double, 6> radial{};
  /// And by 2 p1 x y + p2 (r^2 + 2 x^2) in x, p1 (r^2 + 2 y^2) + 2 p2 x y in y.
  std::array<double, 2> tangential{};

  bool operator==(const LensDistortion&) const = default;
  bool is_none() const { return *this == LensDistortion(); }
  /// Where the lens shows a point that is x, y without distortion.
  Eigen::Vector2d distorted(double x, double y) const;
};

/// What a pinhole of the same intrinsics (K: last row 0 0 1) would have seen: bilinear, and 0 where
/// the image shows nothing of it. The same size. O(pixels), parallel.
GrayImage undistorted(const GrayImage& image, const Eigen::Matrix3d& intrinsics,
                      const LensDistortion& distortion);
/// The same in color.
Image undistorted(const Image& image, const Eigen::Matrix3d& intrinsics,
                  const LensDistortion& distortion);

}  // namespace transformesh
