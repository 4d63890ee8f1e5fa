/// Normals and distances that stay right beside corners that are far away: differences are taken
/// from the nearest corner, since a far one would drown what is small in what differences of large
/// numbers lose. In doubles; no product overflows.
#pragma once

#include "mesh/triangle.h"

namespace transformesh {

/// The normal of length 1, or zero where the corners seem to lie on one line. It is computed at the
/// corner across the longest edge.
Vec3 unit_normal(const Triangle& triangle);

/// The distance from the plane through the triangle with that normal, positive in front.
double height_over(const Triangle& triangle, const Vec3& unit_normal, const Vec3& point);

/// The distance from the line through a and b, and how far the foot lies beyond the nearer of them;
/// negative where it lies between them.
struct LineDistance {
  double distance = 0;
  double beyond = 0;
};
LineDistance distance_from_line(const Vec3& a, const Vec3& b, const Vec3& point);

/// The least height of a triangle as a share of its longest edge; zero where it has no area.
double relative_height(const Triangle& triangle);

}  // namespace transformesh
