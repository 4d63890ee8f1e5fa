/// A pinhole camera as a 3x4 projection P. With q = P (X, 1), the pixel is (q1 / q3, q2 / q3), x to
/// the right and y down, with pixel centers at integers. The depth along the viewing axis is q3. It
/// is in input units if the first three numbers of the third row have length 1.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Unaligned, so that the layout does not depend on compiler options for Eigen.
using Projection = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;

struct Camera {
  Projection projection = Projection::Identity();
  int width = 0;
  int height = 0;

  /// Returns pixel times depth, and depth.
  Vec3 project(const Vec3& point) const {
    return projection.leftCols<3>() * point + projection.col(3);
  }
  Vec3 center() const;
  /// Returns the same view with `factor` times as many pixels along each axis.
  Camera resampled(int factor) const;
};

enum class Axis { x, y, z };

/// Position of the camera on a sphere around its target. Angles are in degrees. At azimuth 0 and
/// elevation 0 the camera is in front of the target. The front is +z for up = y, -y for up = z, and
/// +z for up = x. Azimuth moves the camera to its right, elevation upwards.
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

/// The target of a camera and its distance.
struct Aim {
  Vec3 target = Vec3::Zero();
  double distance = 1;  ///< > 0
};

/// Returns the aim with which the points fill the image except for a small margin. There must be at
/// least one point. The field of view is 30 degrees along the shorter side. The distance is 1 if
/// all points are equal.
Aim aim_at(std::span<const Vec3> points, const Orbit& orbit, int width, int height);

/// Returns an aim at the center of the points' bounding box. The distance is the least one for
/// which all points are inside the image at any azimuth, with the same margin.
Aim turn_aim(std::span<const Vec3> points, const Orbit& orbit, int width, int height);

/// Returns the camera. Zoom narrows the field of view.
Camera orbit_camera(const Aim& aim, const Orbit& orbit, int width, int height);

}  // namespace transformesh
