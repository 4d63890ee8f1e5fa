#include "views/depth/depth_surface.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace transformesh {
namespace {

/// Lower bound of the cosine between viewing ray and normal. Smaller cosines are replaced by this
/// value, because slopes of steeper surfaces are inaccurate. Without a bound, distances from
/// surfaces nearly parallel to the ray would become 0.
constexpr double least_cosine = 0.2;
/// Cosine between viewing ray and normal that is assumed if no neighboring pixel shows the same
/// surface.
constexpr double unknown_cosine = 0.5;

}  // namespace

DepthSurface::DepthSurface(const PinholeCamera& camera, DepthMap map, double tolerance)
    : projection_(camera.projection()),
      center_(camera.center()),
      to_ray_(camera.rotation.transpose() * camera.intrinsics.inverse()),
      map_(std::move(map)),
      gap_(tolerance * map_.plane_gap),
      height_(map_.depth.width, map_.depth.height) {
  for (int y = 0; y < height_.height; ++y)
    for (int x = 0; x < height_.width; ++x)
      if (map_.depth.at(x, y) > 0) height_.at(x, y) = static_cast<float>(height_per_depth(x, y));
}

Vec3 DepthSurface::point_of(int x, int y) const {
  return center_ + map_.depth.at(x, y) * ray(x, y);
}

bool DepthSurface::is_same(float here, float there) const {
  return there > 0 && std::abs(1 / here - 1 / there) <= gap_;
}

// Returns the factor that converts a difference of depth at pixel (x, y) to a distance from the
// tangent plane. The tangent plane is found from the neighbors on both sides along x and y or, if
// one is on another surface, from the pixel and one neighbor.
double DepthSurface::height_per_depth(int x, int y) const {
  const GrayImage& depth = map_.depth;
  const float here = depth.at(x, y);
  const Vec3 own_ray = ray(x, y);
  const auto along = [&](int dx, int dy) -> Vec3 {
    const auto end = [&](int sign) -> Vec3 {
      const int to_x = x + sign * dx, to_y = y + sign * dy;
      const bool is_in = to_x >= 0 && to_y >= 0 && to_x < depth.width && to_y < depth.height;
      if (!is_in || !is_same(here, depth.at(to_x, to_y))) return here * own_ray;
      return depth.at(to_x, to_y) * ray(to_x, to_y);
    };
    return end(1) - end(-1);
  };
  const Vec3 normal = along(1, 0).cross(along(0, 1));
  if (!(normal.norm() > 0)) return unknown_cosine * own_ray.norm();
  return std::max(std::abs(own_ray.dot(normal.normalized())), least_cosine * own_ray.norm());
}

// Returns the depth at (x, y): interpolated between four pixels if they are on the same surface,
// else that of the nearest pixel.
double DepthSurface::depth_at(double x, double y) const {
  const GrayImage& depth = map_.depth;
  const auto column = static_cast<int>(x), row = static_cast<int>(y);
  const auto nearest_x = static_cast<int>(x + 0.5), nearest_y = static_cast<int>(y + 0.5);
  const float nearest = depth.at(nearest_x, nearest_y);
  if (nearest == 0 || column + 1 >= depth.width || row + 1 >= depth.height) return nearest;
  const float* const top = depth.row(row) + column;
  const float* const bottom = depth.row(row + 1) + column;
  for (const float corner : {top[0], top[1], bottom[0], bottom[1]})
    if (!is_same(nearest, corner)) return nearest;
  const double s = x - column, t = y - row;
  return (1 - t) * ((1 - s) * top[0] + s * top[1]) + t * ((1 - s) * bottom[0] + s * bottom[1]);
}

std::optional<SurfaceDistance> DepthSurface::distance_of(const Vec3& point) const {
  const Vec3 q = projection_.leftCols<3>() * point + projection_.col(3);
  if (!(q.z() > 0)) return std::nullopt;
  const double x = q.x() / q.z(), y = q.y() / q.z();
  if (!(x >= 0 && y >= 0 && x <= map_.depth.width - 1 && y <= map_.depth.height - 1))
    return std::nullopt;
  const double depth = depth_at(x, y);
  if (!(depth > 0)) return std::nullopt;
  const double height = height_.at(static_cast<int>(x + 0.5), static_cast<int>(y + 0.5));
  const double length = (point - center_).norm() / q.z();
  return SurfaceDistance{(depth - q.z()) * height, height / length};
}

}  // namespace transformesh
