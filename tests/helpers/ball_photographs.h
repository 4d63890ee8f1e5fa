/// Photographs of a textured ball from a ring of cameras, for tests of photoconsistency steps.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "helpers/shapes.h"
#include "views/cameras/view.h"

namespace transformesh::test {

/// Returns the intensity of a solid texture at a point.
inline float texture(const Vec3& p) {
  const double sum = std::sin(17 * p.x() + 3) + std::sin(15 * p.y() + 5 * p.z()) +
                     std::sin(19 * p.z() - 4 * p.x()) + std::sin(11 * (p.x() + p.y() - p.z()));
  return static_cast<float>(128 + 25 * sum);
}

/// Returns a ray-traced view of a textured sphere of radius `size` from a camera on a ring around
/// it.
inline View photograph(double angle_deg, double size) {
  View view;
  view.camera.intrinsics << 260, 0, 79.5, 0, 260, 79.5, 0, 0, 1;
  view.camera.rotation =
      Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, Vec3::UnitY()).toRotationMatrix();
  view.camera.translation = {0, 0, 5 * size};
  view.image = view.silhouette = GrayImage(160, 160);
  const Vec3 eye = view.camera.center() / size;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Vec3 ray = view.camera.ray(x, y).normalized();
      const double along = -eye.dot(ray);
      const double inside = 1 - (eye + along * ray).squaredNorm();
      if (inside < 0) continue;
      view.image.at(x, y) = texture(eye + (along - std::sqrt(inside)) * ray);
      view.silhouette.at(x, y) = 255;
    }
  }
  return view;
}

inline std::vector<View> ring(double size = 1, bool with_silhouettes = false) {
  std::vector<View> views;
  for (int i = 0; i < 16; ++i) {
    views.push_back(photograph(22.5 * i, size));
    if (!with_silhouettes) views.back().silhouette = GrayImage();
  }
  return views;
}

inline Mesh ball(double radius) {
  Mesh mesh = icosphere(4);
  for (Vec3& p : mesh.positions) p *= radius;
  return mesh;
}

/// Returns the mean distance of vertices from a sphere. Only vertices near the equator count,
/// because several views show them.
inline double error(const Mesh& mesh, double radius) {
  double sum = 0;
  int count = 0;
  for (const Vec3& p : mesh.positions) {
    if (std::abs(p.y()) > 0.6 * p.norm()) continue;
    sum += std::abs(p.norm() - radius);
    ++count;
  }
  return sum / count;
}

}  // namespace transformesh::test
