/// Where rounding may have misplaced a surface that was cut: around the new faces of the output,
/// and around the faces of the input that it no longer has, as slivers of them that are thinner
/// than the spacing of numbers may be gone without a trace.
#pragma once

#include <vector>

#include "clean/certify/certify_faces.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"

namespace transformesh {

/// How far rounding may have moved each of the faces along each axis: four times as far as its
/// corners, the midpoints of its edges and its centroid are from the input, but at least twice the
/// spacing of numbers of the type `coordinate` at the face, and at most 1024 times that at the
/// face's largest coordinate.
std::vector<Vec3> rounding_margins(const Mesh& input, const Mesh& output,
                                   const std::vector<Index>& faces, Scalar coordinate);

/// Whether the point may lie on the triangle but for rounding: whether it is within the margins of
/// it along each axis.
bool is_within(const Vec3& margins, const Vec3& point, const Triangle& triangle);

class RoundingZone {
 public:
  /// The output was stored in numbers of the type `coordinate`.
  RoundingZone(const Mesh& input, const Mesh& output, const FaceMatch& match, Scalar coordinate);

  bool contains(const Vec3& point) const;
  /// How far a surface, or a point on it, may be misplaced at that point along each axis.
  Vec3 margins_at(const Vec3& point) const;
  /// The largest of all margins along any axis.
  double largest_margin() const;

 private:
  std::vector<Triangle> triangles_;
  std::vector<Vec3> margins_;  ///< of each triangle
  Bvh bvh_;                    ///< of a box around each triangle and its margins
};

}  // namespace transformesh
