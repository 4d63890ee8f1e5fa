/// Exact signs of orientations of points in doubles. A floating-point filter with a proven error
/// bound decides nearly every call, and exact arithmetic decides the others. Hence the sign is
/// correct for all finite coordinates, even if the filter overflows or underflows. Reference:
/// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates",
/// DCG 1997 (bounds of the filter). Departure: integers of fixed length and monomial sums replace
/// adaptive expansions. Thread-safe; deterministic. A call takes a few nanoseconds if the filter
/// decides, and about a microsecond otherwise.
#pragma once

#include <vector>

#include "mesh/triangle.h"

namespace transformesh {

/// The two coordinates that remain in a projection along an axis.
struct PlaneProjection {
  int u = 0;
  int v = 1;
};

/// Returns +1 if d is on the side of abc to which its normal points (abc is counter-clockwise when
/// viewed from there). Returns -1 on the other side, and 0 if d is in the plane or abc is
/// degenerate.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The plane of a triangle, for testing several points. side_of() returns the same sign as
/// orient3d(). filtered_side_of() returns 0 if the floating-point filter does not decide. Keeps
/// references.
class OrientedPlane {
 public:
  OrientedPlane(const Vec3& a, const Vec3& b, const Vec3& c);
  int side_of(const Vec3& point) const;
  int filtered_side_of(const Vec3& point) const;

 private:
  const Vec3 &a_, &b_, &c_;
  Vec3 normal_;
  /// For each coordinate of `normal_`, the sum of the absolute values of its products; for error
  /// bounds.
  Vec3 size_;
};

/// Returns the orientation of the projected triangle abc: +1 if it is counter-clockwise, -1 if it
/// is clockwise, 0 if it is collinear.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection projection);

/// True if the three points are on one line; also if two of them are equal.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns a projection in which the triangle is counter-clockwise and not degenerate. The triangle
/// must not be collinear.
PlaneProjection projection_of(const Triangle& triangle);

/// Returns the sign of the dot product of the normals of two triangles.
int normals_dot(const Triangle& first, const Triangle& second);

/// Returns the sign of one coordinate (0, 1 or 2) of the cross product of the normals of two
/// triangles.
int normals_cross(const Triangle& first, const Triangle& second, int coordinate);

/// Returns the faces without area, whose corners are collinear; ascending. O(n); parallel.
std::vector<Index> degenerate_faces(const Mesh& mesh);

/// Compares by x, then y, then z: -1, 0 or +1. Positions must be finite.
int compare_positions(const Vec3& a, const Vec3& b);

}  // namespace transformesh
