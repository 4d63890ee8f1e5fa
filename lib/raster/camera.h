/// A pinhole camera as a 3x4 projection P. With q = P (X, 1), the pixel is (q1 / q3, q2 / q3), x to
/// the right and y down, with pixel centers at integers. The depth along the viewing axis is q3. It
/// is in input units if the first three numbers of the third row have length 1.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// The matrix P. Not aligned, so that its memory layout does not depend on compiler options for
/// Eigen.
using Projection = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;

struct Camera {
  Projection projection = Projection::Identity();
  int width = 0;
  int height = 0;

  /// Returns q = P (point, 1): the pixel times the depth, then the depth.
  Vec3 project(const Vec3& point) const {
    return projection.leftCols<3>() * point + projection.col(3);
  }
  Vec3 center() const;
  /// Returns the camera of the same image with `factor` times as many pixels along each axis.
  Camera resampled(int factor) const;
};

enum class Axis { x, y, z };

/// Position of the camera on a sphere around its target. Angles are in degrees. At azimuth 0 and
/// elevation 0 the camera is in front of the target. The front is the direction +z if `up` is x or
/// y, and -y if `up` is z. A larger azimuth moves the camera to its right, a larger elevation moves
/// it upwards.
struct Orbit {
  double azimuth_deg = 30;
  double elevation_deg = 20;
  Axis up = Axis::y;
  double zoom = 1;  ///< magnification, > 0
};

/// Unit axes of the camera: to its right, upwards and backwards.
struct EyeAxes {
  Vec3 right, up, back;
};
EyeAxes eye_axes(const Orbit& orbit);

/// The point at which a camera looks, and its distance from the camera.
struct Aim {
  Vec3 target = Vec3::Zero();
  double distance = 1;  ///< distance of the camera from `target`, > 0
};

/// Returns the aim with which the points fill the image except for a margin: 4 % of width or height
/// on each side. There must be at least one point. The field of view is 30 degrees along the
/// shorter side. The distance is 1 if all points are equal.
Aim aim_at(std::span<const Vec3> points, const Orbit& orbit, int width, int height);

/// Returns an aim at the center of the points' bounding box, for a camera that turns around the
/// object. The distance is the least one for which all points are inside the image at any azimuth,
/// with the margin of aim_at().
Aim turn_aim(std::span<const Vec3> points, const Orbit& orbit, int width, int height);

/// Returns the camera with this aim and orbit. A zoom above 1 narrows the field of view.
Camera orbit_camera(const Aim& aim, const Orbit& orbit, int width, int height);

}  // namespace transformesh
