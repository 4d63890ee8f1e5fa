/// Normals of triangles, and distances of points from triangles and lines, that stay accurate if
/// some corners are far away. Positions are subtracted from the nearest corner, because differences
/// to far corners would lose small values by rounding. In doubles; no product overflows.
#pragma once

#include "mesh/triangle.h"

namespace transformesh {

/// Returns the unit normal, or zero if the corners are collinear within rounding. The normal is
/// computed at the corner opposite to the longest edge.
Vec3 unit_normal(const Triangle& triangle);

/// Returns the distance of a point from the plane of the triangle, positive in front.
double height_over(const Triangle& triangle, const Vec3& unit_normal, const Vec3& point);

/// Distance of a point from the line through two points a and b. `beyond` is the distance of the
/// point's projection from the nearer of a and b; negative if the projection is between a and b.
struct LineDistance {
  double distance = 0;
  double beyond = 0;
};
LineDistance distance_from_line(const Vec3& a, const Vec3& b, const Vec3& point);

/// Returns the least height of a triangle divided by its longest edge; zero if it has no area.
double relative_height(const Triangle& triangle);

}  // namespace transformesh
