/// Planes that separate a triangle from the faces at a vertex.
///
/// Faces at a vertex lie in the cone of the directions in which they leave the vertex. If a plane
/// through the vertex has the triangle on one side and all these directions on the other side, the
/// triangle meets the faces at most in the vertex. Planes do not depend on the lengths of edges,
/// so that they also separate long and narrow faces, whose bounding boxes overlap.
#pragma once

#include "geometry/search/float_box.h"
#include "mesh/triangle.h"

namespace transformesh {

class StarPlanes {
 public:
  /// Finds planes through the vertex with the triangle on one side. There are none if the triangle
  /// is near the vertex, unless the vertex is a corner of the triangle.
  StarPlanes(const Vec3& vertex, const Triangle& triangle);

  /// True if one of the planes separates the triangle from all unit directions in the box.
  bool separate(const FloatBox& directions) const;

 private:
  void add(const Vec3& normal);
  void add_at_corner(const Vec3& first, const Vec3& second);
  void add_at_edges(const Triangle& triangle);

  std::array<Vec3, 4> normals_;  ///< unit normals; the triangle is behind each plane
  std::size_t count_ = 0;
};

}  // namespace transformesh
