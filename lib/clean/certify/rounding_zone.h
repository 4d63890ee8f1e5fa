/// The neighborhood in which rounding may have moved a cut surface. It surrounds the new faces of
/// the output, and the faces of the input that are not in the output. Slivers of the input that are
/// thinner than the spacing of numbers may have vanished completely. Cost: O(n log n) to build;
/// O(log n) per query on usual meshes.
#pragma once

#include <vector>

#include "clean/certify/certify_faces.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"

namespace transformesh {

/// Returns per face an upper bound of the movement by rounding, along each axis. The bound is four
/// times the distance of the corners, edge midpoints and centroid from the input. It is at least
/// twice the spacing of type `coordinate` at the face, and at most 1024 times the spacing at the
/// largest coordinate of the face.
std::vector<Vec3> rounding_margins(const Mesh& input, const Mesh& output,
                                   const std::vector<Index>& faces, Scalar coordinate);

/// True if the point is within the margins of the triangle along each axis. Then the point may be
/// on the triangle, up to rounding.
bool is_within(const Vec3& margins, const Vec3& point, const Triangle& triangle);

class RoundingZone {
 public:
  /// `coordinate` is the type in which the output was stored.
  RoundingZone(const Mesh& input, const Mesh& output, const FaceMatch& match, Scalar coordinate);

  bool contains(const Vec3& point) const;
  /// Returns an upper bound of the movement of a surface at a point, along each axis.
  Vec3 margins_at(const Vec3& point) const;
  double largest_margin() const;

 private:
  std::vector<Triangle> triangles_;
  std::vector<Vec3> margins_;  ///< margins of each triangle along the axes
  Bvh bvh_;                    ///< boxes around triangles and their margins
};

}  // namespace transformesh
