/// Points beside faces at which the winding numbers of a mesh and of what was made from it can be
/// compared: nearer to the face than any other face of either, and farther from new faces than
/// rounding may have moved those.
#pragma once

#include <optional>

#include "tm/clean/certify_faces.h"
#include "tm/geometry/ray_winding.h"

namespace transformesh {

struct WindingSample {
  Vec3 point = Vec3::Zero();
  int input_winding = 0;
  int output_winding = 0;
};

class SampleFinder {
 public:
  /// Keeps references. The input must be closed. The output was stored in numbers of that type.
  SampleFinder(const Mesh& input, const Mesh& output, const FaceMatch& match, Scalar coordinate);

  /// In front of the face (side 1) or behind it (-1); nothing where no point will do.
  std::optional<WindingSample> find(const Mesh& mesh, Index face, int side) const;

 private:
  Vec3 margins_at(const Vec3& point) const;
  bool may_be_misplaced(const Vec3& point) const;
  std::optional<WindingSample> find_above(const Vec3& base, const Vec3& direction,
                                          double height) const;

  RayWinding input_winding_;
  RayWinding output_winding_;
  const Mesh* output_;
  std::vector<Index> new_faces_;
  std::vector<Vec3> margins_;  ///< of the new faces
  Bvh new_bvh_;                ///< the new faces, each box wider by its margins
};

/// How far rounding may have moved each of the faces along each axis: four times as far as its
/// corners, the middles of its edges and its centroid are from the input, but at least twice the
/// spacing of numbers of that type at its coordinates, and at most 1024 times that at the largest
/// coordinate of the mesh.
std::vector<Vec3> rounding_margins(const Mesh& input, const Mesh& output,
                                   const std::vector<Index>& faces, Scalar coordinate);

/// Whether the point is so near to the triangle that one may lie on the other but for rounding.
bool is_within(const Vec3& margins, const Vec3& point, const Triangle& triangle);

}  // namespace transformesh
