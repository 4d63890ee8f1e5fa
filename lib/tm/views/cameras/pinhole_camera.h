/// A calibrated photograph's camera without distortion: K [R | t] from the world to pixels.
/// Reference: Hartley & Zisserman, "Multiple View Geometry in Computer Vision", chapter 6.
///
/// With q = K (R X + t) the pixel is (q1 / q3, q2 / q3), x to the right and y down, integers at
/// pixel centres; q3 is the depth in units of the world. The ray of a pixel is scaled so that
/// X = center() + depth * ray(x, y).
#pragma once

#include "tm/picture/camera.h"

namespace transformesh {

struct PinholeCamera {
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();  ///< K: last row 0 0 1, focals > 0
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();    ///< R, determinant 1
  Vec3 translation = Vec3::Zero();                           ///< t

  Vec3 center() const;
  Vec3 ray(double x, double y) const;
  Projection projection() const;
  /// Pixels per unit of length at depth 1: the mean of both axes.
  double focal_length() const;
  /// The camera of the image made `factor` times smaller each way (> 0): pixel areas stay aligned.
  PinholeCamera shrunk(double factor) const;
};

}  // namespace transformesh
