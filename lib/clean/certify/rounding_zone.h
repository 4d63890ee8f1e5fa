/// The rounding zone: the points over which rounding of new vertices may have moved a surface. It
/// surrounds the new faces of the output, and the faces of the input that are not in the output.
/// Slivers of the input that are thinner than the spacing of numbers may have vanished completely.
/// Cost: O(n log n) to build; O(log n) per query on usual meshes.
#pragma once

#include <vector>

#include "clean/certify/certify_faces.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"

namespace transformesh {

/// Returns for each face an upper bound, along each axis, of the distance by which rounding moved
/// it. The bound is four times the largest distance of the corners, edge midpoints and centroid
/// from the input. It is at least twice the spacing of type `coordinate` at the face, and at most
/// 1024 times the spacing at the largest coordinate of the face.
std::vector<Vec3> rounding_margins(const Mesh& input, const Mesh& output,
                                   const std::vector<Index>& faces, Scalar coordinate);

/// True if a point of the triangle differs from `point` by at most `margins` along each axis.
/// Rounding errors of the test may also make it true for points slightly farther away.
bool is_within(const Vec3& margins, const Vec3& point, const Triangle& triangle);

class RoundingZone {
 public:
  /// `coordinate` is the type in which the output was stored.
  RoundingZone(const Mesh& input, const Mesh& output, const FaceMatch& match, Scalar coordinate);

  bool contains(const Vec3& point) const;
  /// Returns an upper bound, along each axis, of the distance by which rounding may have moved the
  /// surfaces at a point.
  Vec3 margins_at(const Vec3& point) const;
  double largest_margin() const;

 private:
  std::vector<Triangle> triangles_;
  std::vector<Vec3> margins_;  ///< margins of each triangle along the axes
  Bvh bvh_;                    ///< boxes around triangles and their margins
};

}  // namespace transformesh
