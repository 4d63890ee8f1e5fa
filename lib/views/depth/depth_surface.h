/// The surface in a depth map. Computes signed distances of points from its tangent planes.
#pragma once

#include <optional>

#include "raster/camera.h"
#include "views/cameras/view.h"
#include "views/depth/plane_sweep.h"

namespace transformesh {

/// Distance of a point from the surface that a view observes.
struct SurfaceDistance {
  double distance = 0;  ///< distance from the tangent plane; positive in front of the surface
  double cosine = 0;    ///< cosine of the angle between viewing ray and normal; at least 0.2
};

class DepthSurface {
 public:
  /// Neighboring pixels belong to the same surface if their inverse depths differ by at most
  /// `tolerance` times DepthMap::plane_gap.
  DepthSurface(const PinholeCamera& camera, DepthMap map, double tolerance);

  /// Returns the distance of a point from the surface at its pixel, or nothing if the depth is
  /// unknown at that pixel.
  std::optional<SurfaceDistance> distance_of(const Vec3& point) const;
  const GrayImage& depth() const { return map_.depth; }
  /// Returns the point of the surface at pixel (x, y). The depth of the pixel must be known.
  Vec3 point_of(int x, int y) const;

 private:
  bool is_same(float here, float there) const;
  double height_per_depth(int x, int y) const;
  double depth_at(double x, double y) const;

  Vec3 ray(double x, double y) const { return to_ray_ * Vec3(x, y, 1); }

  Projection projection_;
  Vec3 center_;
  Eigen::Matrix3d to_ray_;
  DepthMap map_;
  double gap_;  ///< largest difference of inverse depths of neighboring pixels on the same surface
  /// For each pixel, the factor that converts a difference of depth to a distance from the tangent
  /// plane.
  GrayImage height_;
};

}  // namespace transformesh
