#include "picture/ribbons.h"

#include <Eigen/Geometry>

#include "raster/camera.h"

namespace transformesh {

void add_ribbons(std::span<const std::pair<Vec3, Vec3>> segments, const Camera& camera,
                 double width, Mesh& mesh) {
  const Vec3 eye = camera.center();
  const Vec3 right = camera.projection.row(0).head<3>();
  const Vec3 axis = camera.projection.row(2).head<3>();
  const double focal_length = right.cross(axis).norm();  // in pixels
  for (const auto& [a, b] : segments) {
    const Vec3 across = (b - a).cross(a - eye);
    const double size = across.norm();
    const double depth_a = camera.project(a).z();
    const double depth_b = camera.project(b).z();
    if (!(size > 0 && depth_a > 0 && depth_b > 0)) continue;

    // Each end of the segment gets two vertices, half a width to its left and right. They are one
    // width closer to the camera than the end.
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const auto& [end, depth] : {std::pair(a, depth_a), std::pair(b, depth_b)}) {
      const double length = width * depth / focal_length;
      const Vec3 nearer = end + length * (eye - end).normalized();
      mesh.positions.push_back(nearer + length / 2 / size * across);
      mesh.positions.push_back(nearer - length / 2 / size * across);
    }
    mesh.faces.push_back({first, first + 1, first + 2});
    mesh.faces.push_back({first + 1, first + 3, first + 2});
  }
}

}  // namespace transformesh
