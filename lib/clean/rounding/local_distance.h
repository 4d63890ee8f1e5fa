/// Distances and directions that stay right beside corners that are far away: differences are taken
/// from the nearest corner, since a far one would drown what is small in what differences of large
/// numbers lose. In doubles; no product overflows.
#pragma once

#include "mesh/coordinate_spacing.h"
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
  Vec3 across = Vec3::Zero();  ///< the unit direction of the distance, zero where there is none
};
LineDistance distance_from_line(const Vec3& a, const Vec3& b, const Vec3& point);

/// The spacings of numbers that count at a place: how far rounding moves things there.
struct Spacings {
  Scalar type = Scalar::float64;
  /// Rounding a coordinate of 1e20 moves no plane that lies along its axis. Else the largest
  /// coordinate counts along all axes.
  bool are_per_axis = true;

  /// Per axis, how far a unit direction leads along it: 1, or less below a thousandth.
  Vec3 leads(const Vec3& direction) const;
  /// Along a unit direction: the largest along an axis, where the direction leads along that axis
  /// by a thousandth at least; else as much less.
  double along(const Vec3& direction, const Vec3& point) const;
  /// Per axis, at a corner of a face of that extent: the largest along an axis, as far as the face
  /// leads from that axis to this one. Powers of two.
  Vec3 on_face(const Vec3& extent, const Vec3& corner) const;
};

/// Those for the rounding of a mesh: along each axis its own where the mesh reaches 2^40 times
/// farther than half of its vertices lie. O(n).
Spacings spacings_for(const Mesh& mesh, Scalar type);

}  // namespace transformesh
