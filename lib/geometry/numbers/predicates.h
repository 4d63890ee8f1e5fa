/// Exact signs of orientation of points given in doubles. A floating-point filter with a proven
/// error bound decides almost every call; the rest is decided in exact arithmetic, so the sign is
/// always right, for any finite coordinates, including under- and overflow of the filter.
/// Reference: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates", DCG 1997 (the filter's bounds).
/// Thread-safe; deterministic; a call costs a few nanoseconds when the filter decides and about a
/// microsecond when it does not.
#pragma once

#include <vector>

#include "mesh/triangle.h"

namespace transformesh {

/// The two coordinates kept when a plane is looked at along an axis.
struct PlaneProjection {
  int u = 0;
  int v = 1;
};

/// +1 where d is on the side that the counter-clockwise normal of abc points to, -1 on the other
/// side, 0 in the plane (also when abc is degenerate).
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The plane of a triangle, to find the sides of several points as orient3d does, or 0 where that
/// takes more than the filter. Keeps references.
class OrientedPlane {
 public:
  OrientedPlane(const Vec3& a, const Vec3& b, const Vec3& c);
  int side_of(const Vec3& point) const;
  int filtered_side_of(const Vec3& point) const;

 private:
  const Vec3 &a_, &b_, &c_;
  Vec3 normal_;
  Vec3 size_;  ///< of the products that make the normal
};

/// +1 where abc turns counter-clockwise in the projection, 0 where its image is collinear.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection projection);

/// Whether the three points lie on one line, two equal ones included.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// A projection in which the triangle is not degenerate and turns counter-clockwise. The triangle
/// must not be collinear.
PlaneProjection projection_of(const Triangle& triangle);

/// Sign of the dot product of the normals of two triangles.
int normals_dot(const Triangle& first, const Triangle& second);

/// Sign of one coordinate (0, 1, 2) of the cross product of the normals of two triangles.
int normals_cross(const Triangle& first, const Triangle& second, int coordinate);

/// The faces without area: their corners lie on one line. Ascending; O(n), in parallel.
std::vector<Index> degenerate_faces(const Mesh& mesh);

/// An order by x, then y, then z: -1, 0 or +1. Positions are never NaN or infinite.
int compare_positions(const Vec3& a, const Vec3& b);

}  // namespace transformesh
