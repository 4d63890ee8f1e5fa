/// Two edges of a triangle as the axes of its plane.
#pragma once

#include "mesh/triangle.h"

namespace transformesh {

struct TriangleAxes {
  /// A point as the triangle sees it: shares of the two edges, and the way to it from the point of
  /// the plane that these give.
  struct Place {
    double first, second;
    Vec3 away;
    double rest() const { return 1 - first - second; }
  };

  explicit TriangleAxes(const Triangle& triangle)
      : corner(triangle[0]), first(triangle[1] - triangle[0]), second(triangle[2] - triangle[0]) {
    const Vec3 normal = first.cross(second);
    squared_normal = normal.squaredNorm();
    if (!(squared_normal > 0)) return;
    first_dual = second.cross(normal) / squared_normal;
    second_dual = normal.cross(first) / squared_normal;
  }
  /// Without area, both shares are zero.
  Place place_of(const Vec3& point) const {
    const Vec3 way = point - corner;
    const double share = first_dual.dot(way), other = second_dual.dot(way);
    return {share, other, way - share * first - other * second};
  }

  Vec3 corner;
  Vec3 first, second;              ///< edges from the corner
  Vec3 first_dual = Vec3::Zero();  ///< its product with a way from the corner is the share
  Vec3 second_dual = Vec3::Zero();
  double squared_normal;
};

}  // namespace transformesh
