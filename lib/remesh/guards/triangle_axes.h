/// A coordinate system of a triangle's plane, whose axes are two edges.
#pragma once

#include "mesh/triangle.h"

namespace transformesh {

struct TriangleAxes {
  /// Coordinates of a point: its coordinates along the two edges after projection onto the plane,
  /// and the vector from the projection to the point.
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
  /// Returns the coordinates of a point. If the triangle has no area, `first` and `second` are 0.
  Place place_of(const Vec3& point) const {
    const Vec3 way = point - corner;
    const double share = first_dual.dot(way), other = second_dual.dot(way);
    return {share, other, way - share * first - other * second};
  }

  Vec3 corner;
  Vec3 first, second;  ///< vectors of the two edges from the corner
  /// The product of `first_dual` and a vector from the corner is Place::first.
  Vec3 first_dual = Vec3::Zero();
  Vec3 second_dual = Vec3::Zero();
  double squared_normal;
};

}  // namespace transformesh
