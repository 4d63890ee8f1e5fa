/// A calibrated photograph's camera without distortion: K [R | t] from the world to pixels.
/// Reference: Hartley & Zisserman, "Multiple View Geometry in Computer Vision", chapter 6.
///
/// With q = K (R X + t) the pixel is (q1 / q3, q2 / q3), x to the right and y down, integers at
/// pixel centers; q3 is the depth in units of the world. The ray of a pixel is scaled so that
/// X = center() + depth * ray(x, y).
#pragma once

#include <span>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct PinholeCamera {
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();  ///< K: last row 0 0 1, focals > 0
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();    ///< R, determinant 1
  Vec3 translation = Vec3::Zero();                           ///< t

  Vec3 center() const;
  Vec3 ray(double x, double y) const;
  /// K [R | t].
  Eigen::Matrix<double, 3, 4, Eigen::DontAlign> projection() const;
  /// Pixels per unit of length at depth 1: the mean of both axes.
  double focal_length() const;
  /// The camera of the image made `factor` times smaller each way (> 0): pixel areas stay aligned.
  PinholeCamera shrunk(double factor) const;
  /// The camera that has the reflected world, z for -z, on the same pixels: what was behind it is
  /// before it. Where cameras are of a left-handed world, the scene lies behind all of them.
  PinholeCamera mirrored() const;
};

/// The point nearest to all viewing axes, in the sense of least squares; where that leaves it open
/// (one camera, parallel axes), the nearest such point to the mean of the cameras' centers.
Vec3 viewed_point(std::span<const PinholeCamera> cameras);

/// The length of a pixel's side at the point, in input units: depth by focal length, the median
/// over the cameras that have the point in front of them. Throws InputError where none has.
double pixel_size(std::span<const PinholeCamera> cameras, const Vec3& point);

}  // namespace transformesh
