/// The camera of a calibrated photograph without lens distortion: K [R | t] maps the world to
/// pixels. Reference: Hartley & Zisserman, "Multiple View Geometry in Computer Vision", chapter 6.
///
/// A point X projects to q = K (R X + t) and to the pixel (q1 / q3, q2 / q3), with x to the right,
/// y down, and pixel centers at integers. The depth is q3, in input units. The ray of a pixel is
/// scaled so that X = center() + depth * ray(x, y).
#pragma once

#include <span>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct PinholeCamera {
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();  ///< K: last row 0 0 1, focals > 0
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();    ///< R, with determinant 1
  Vec3 translation = Vec3::Zero();                           ///< t, in input units

  Vec3 center() const;
  Vec3 ray(double x, double y) const;
  /// Returns K [R | t].
  Eigen::Matrix<double, 3, 4, Eigen::DontAlign> projection() const;
  /// Returns the pixels per unit of length at depth 1: the mean of both axes.
  double focal_length() const;
  /// Returns the camera of the image reduced by `factor` > 0 in each direction; pixel areas stay
  /// aligned.
  PinholeCamera shrunk(double factor) const;
  /// Returns the camera that maps the reflected world (z replaced by -z) to the same pixels: points
  /// behind the camera come in front of it. Needed for cameras of a left-handed world, where the
  /// scene lies behind all cameras.
  PinholeCamera mirrored() const;
};

/// Returns the point with the least sum of squared distances from all viewing axes. If this point
/// is not unique (one camera, parallel axes), returns the one nearest to the mean of the camera
/// centers.
Vec3 viewed_point(std::span<const PinholeCamera> cameras);

/// Returns the side length of a pixel at the point, in input units: depth divided by focal length.
/// Takes the median over the cameras that have the point in front of them. Throws InputError if
/// there are none.
double pixel_size(std::span<const PinholeCamera> cameras, const Vec3& point);

}  // namespace transformesh
