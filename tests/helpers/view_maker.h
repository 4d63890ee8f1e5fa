/// Views of objects that a test describes by a formula.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "views/cameras/view.h"

namespace view_maker {

using namespace transformesh;

struct Frame {
  int width = 320;
  int height = 240;
  double focal_length = 600;
};

/// Returns a camera at `eye` that points to the origin, with x to its right and y down.
inline PinholeCamera camera_at(const Vec3& eye, const Frame& frame = {}) {
  const Vec3 forward = -eye.normalized();
  const Vec3 up = std::abs(forward.z()) > 0.99 ? Vec3::UnitY() : Vec3::UnitZ();
  const Vec3 right = forward.cross(up).normalized();
  PinholeCamera camera;
  camera.intrinsics << frame.focal_length, 0, (frame.width - 1) / 2.0, 0, frame.focal_length,
      (frame.height - 1) / 2.0, 0, 0, 1;
  camera.rotation.row(0) = right;
  camera.rotation.row(1) = forward.cross(right);
  camera.rotation.row(2) = forward;
  camera.translation = -camera.rotation * eye;
  return camera;
}

/// Returns a view whose silhouette has a soft contour. `distance(ray)` is the signed angle between
/// a unit ray from the eye and the contour, in radians, positive outside.
template <typename Distance>
View view_of(const PinholeCamera& camera, const Frame& frame, const Distance& distance) {
  View view;
  view.camera = camera;
  view.silhouette = GrayImage(frame.width, frame.height);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double pixels = distance(camera.ray(x, y).normalized()) * frame.focal_length;
      view.silhouette.at(x, y) = static_cast<float>(std::clamp(127.5 - 90 * pixels, 0.0, 255.0));
    }
  }
  return view;
}

/// Returns the signed angle between a ray from `eye` and the contour of a ball, for view_of().
inline auto ball_contour(const Vec3& eye, const Vec3& center, double radius) {
  return [=](const Vec3& ray) {
    const Vec3 towards = (center - eye).normalized();
    const double angle = std::atan2(ray.cross(towards).norm(), ray.dot(towards));
    return angle - std::asin(radius / (center - eye).norm());
  };
}

inline View ball_view(const Vec3& eye, const Vec3& center, double radius, const Frame& frame = {}) {
  View view = view_of(camera_at(eye, frame), frame, ball_contour(eye, center, radius));
  view.name = "ball";
  return view;
}

/// Returns positions on a ring around the z axis, alternately above and below the plane z = 0.
inline std::vector<Vec3> ring_of_eyes(int count, double distance, double elevation_deg) {
  std::vector<Vec3> eyes;
  for (int i = 0; i < count; ++i) {
    const double azimuth = 2 * 3.14159265358979 * i / count;
    const double elevation = (i % 2 == 0 ? 1 : -1) * elevation_deg * 3.14159265358979 / 180;
    eyes.push_back(distance * Vec3(std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth), std::sin(elevation)));
  }
  return eyes;
}

}  // namespace view_maker
