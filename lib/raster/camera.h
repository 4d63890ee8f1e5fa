/// A pinhole camera as a 3x4 projection. With q = P (X, 1): the pixel is (q1 / q3, q2 / q3), x to
/// the right and y down, integers at pixel centers; q3 is the depth along the viewing axis, in
/// input units where the first three numbers of the third row have length 1.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Not aligned, so that its layout does not depend on how Eigen is compiled.
using Projection = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;

struct Camera {
  Projection projection = Projection::Identity();
  int width = 0;
  int height = 0;

  /// Pixel times depth, and depth.
  Vec3 project(const Vec3& point) const {
    return projection.leftCols<3>() * point + projection.col(3);
  }
  Vec3 center() const;
  /// The same view with `factor` times as many pixels each way.
  Camera resampled(int factor) const;
};

enum class Axis { x, y, z };

/// Where the eye is on a sphere around what it looks at. Angles in degrees. Azimuth 0 and
/// elevation 0 is the front: for up = y the eye is at +z, for z at -y, for x at +z. Azimuth moves
/// the eye to its right, elevation upwards.
struct Orbit {
  double azimuth_deg = 30;
  double elevation_deg = 20;
  Axis up = Axis::y;
  double zoom = 1;  ///< > 0; 2 shows things twice as large
};

/// Unit axes of the eye: to its right, upwards and backwards.
struct EyeAxes {
  Vec3 right, up, back;
};
EyeAxes eye_axes(const Orbit& orbit);

/// What an eye looks at, and from how far.
struct Aim {
  Vec3 target = Vec3::Zero();
  double distance = 1;  ///< > 0
};

/// The aim for which the points, at least one, fill the image but for a small margin. The field of
/// view is 30 degrees along the shorter side. Distance 1 where all points are the same.
Aim aim_at(std::span<const Vec3> points, const Orbit& orbit, int width, int height);

/// The aim at the middle of the points' box for which they stay inside, but for the same margin,
/// whatever the azimuth; some reach the margin at some azimuth.
Aim turn_aim(std::span<const Vec3> points, const Orbit& orbit, int width, int height);

/// Zoom narrows the field of view.
Camera orbit_camera(const Aim& aim, const Orbit& orbit, int width, int height);

}  // namespace transformesh
