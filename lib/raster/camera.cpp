#include "raster/camera.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <numbers>

#include "support/elementary/trigonometric.h"

namespace transformesh {
namespace {

constexpr double field_of_view_deg = 30;  ///< field of view along the shorter side of the image
/// Fraction of the image's width or height that the points fill.
constexpr double filled_share = 0.92;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

EyeAxes front_axes(Axis up) {
  switch (up) {
    case Axis::x:
      return {-Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()};
    case Axis::y:
      return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    default:
      return {Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()};
  }
}

/// Returns the focal length in pixels, without zoom.
double focal_length(int width, int height) {
  return 0.5 * std::min(width, height) / elementary::tan(radians(field_of_view_deg / 2));
}

/// Result of fit(): `middle` is the position of the camera along one axis of the image. `eye_back`
/// is its position along the axis that points from the target to the camera.
struct Fit {
  double middle = 0;
  double eye_back = 0;
};

/// Returns the camera position closest to the points for which all points are inside the image
/// along one image axis. Coordinates are measured along `direction` (u) and `back` (d). A point (u,
/// d) is inside the image of a camera at (m, b) if |u - m| * slope <= b - d. This bounds both b +
/// slope m and b - slope m from below. The least b has both at their bounds.
Fit fit(std::span<const Vec3> points, const Vec3& direction, const Vec3& back, double slope) {
  double plus = -HUGE_VAL;
  double minus = -HUGE_VAL;
  for (const Vec3& point : points) {
    const double place = slope * direction.dot(point);
    plus = std::max(plus, back.dot(point) + place);
    minus = std::max(minus, back.dot(point) - place);
  }
  return {(plus - minus) / (2 * slope), plus + (minus - plus) / 2};
}

Vec3 box_middle(std::span<const Vec3> points) {
  Vec3 low = points[0];
  Vec3 high = points[0];
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return low / 2 + high / 2;
}

}  // namespace

Vec3 Camera::center() const {
  const Eigen::Matrix3d left = projection.leftCols<3>();
  return -left.inverse() * projection.col(3);
}

Camera Camera::resampled(int factor) const {
  // Pixel x becomes factor x + (factor - 1) / 2, so that the border of the image, at -1/2, is
  // fixed.
  Camera camera{projection, width * factor, height * factor};
  for (int row = 0; row < 2; ++row)
    camera.projection.row(row) =
        factor * projection.row(row) + 0.5 * (factor - 1) * projection.row(2);
  return camera;
}

EyeAxes eye_axes(const Orbit& orbit) {
  const EyeAxes front = front_axes(orbit.up);
  const double azimuth = radians(orbit.azimuth_deg);
  const double elevation = radians(orbit.elevation_deg);
  const Vec3 right = elementary::cos(azimuth) * front.right - elementary::sin(azimuth) * front.back;
  const Vec3 horizontal_back =
      elementary::sin(azimuth) * front.right + elementary::cos(azimuth) * front.back;
  const Vec3 back =
      elementary::cos(elevation) * horizontal_back + elementary::sin(elevation) * front.up;
  return {right, back.cross(right), back};
}

Aim aim_at(std::span<const Vec3> points, const Orbit& orbit, int width, int height) {
  const EyeAxes axes = eye_axes(orbit);
  const double focal = focal_length(width, height);
  const Fit across = fit(points, axes.right, axes.back, focal / (filled_share * width / 2));
  const Fit along = fit(points, axes.up, axes.back, focal / (filled_share * height / 2));
  const double eye_back = std::max(across.eye_back, along.eye_back);

  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Vec3& point : points) {
    low = std::min(low, axes.back.dot(point));
    high = std::max(high, axes.back.dot(point));
  }
  const double middle = low + (high - low) / 2;
  const double distance = eye_back - middle;
  return {across.middle * axes.right + along.middle * axes.up + middle * axes.back,
          distance > 0 ? distance : 1};
}

Aim turn_aim(std::span<const Vec3> points, const Orbit& orbit, int width, int height) {
  const double focal = focal_length(width, height);
  const double slope_across = focal / (filled_share * width / 2);
  const double slope_along = focal / (filled_share * height / 2);
  const double cosine = elementary::cos(radians(orbit.elevation_deg));
  const double sine = elementary::sin(radians(orbit.elevation_deg));
  const Vec3 up = front_axes(orbit.up).up;
  const Vec3 middle = box_middle(points);

  // Let (r, a, h) be cylindrical coordinates of a point around `middle`: radius, azimuth relative
  // to the camera, and height. The point is r sin a to the right of `middle`, as observed by the
  // camera. It is h cosine - r sine cos a above `middle`, and n = r cosine cos a + h sine nearer to
  // the camera. The distance must be at least n plus the slope times the offset to the right, up or
  // down. The maximum of each such sum over all a has a closed form.
  double distance = 0;
  for (const Vec3& point : points) {
    const double height_of = up.dot(point - middle);
    const double radius = (point - middle - height_of * up).norm();
    const double across =
        radius * std::sqrt(slope_across * slope_across + cosine * cosine) + sine * height_of;
    const double above =
        radius * std::abs(cosine - slope_along * sine) + height_of * (sine + slope_along * cosine);
    const double below =
        radius * std::abs(cosine + slope_along * sine) + height_of * (sine - slope_along * cosine);
    distance = std::max({distance, across, above, below});
  }
  return {middle, distance > 0 ? distance : 1};
}

Camera orbit_camera(const Aim& aim, const Orbit& orbit, int width, int height) {
  const EyeAxes axes = eye_axes(orbit);
  const double focal = focal_length(width, height) * orbit.zoom;
  Eigen::Matrix3d directions;
  directions.row(2) = -axes.back;
  directions.row(0) = focal * axes.right.transpose() + 0.5 * (width - 1) * directions.row(2);
  directions.row(1) = -focal * axes.up.transpose() + 0.5 * (height - 1) * directions.row(2);

  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.projection.leftCols<3>() = directions;
  camera.projection.col(3) = -directions * (aim.target + aim.distance * axes.back);
  return camera;
}

}  // namespace transformesh
