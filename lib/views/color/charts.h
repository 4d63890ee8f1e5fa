/// Divides a surface into planar charts. Each chart is projected along its mean normal. Lengths
/// shrink by a factor of at most 2, except for few faces. Faces of a chart do not overlap by more
/// than a texel.
///
/// Charts grow across edges of two faces, beginning at the first face without chart. Every face
/// belongs to a chart. O(n) except for sorting; deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct Chart {
  std::vector<Index> faces;
  /// Corners of each face in the plane, in input units. The lower corner of the bounding box is at
  /// 0. The chart is rotated such that the box is small, and wider than high.
  std::vector<std::array<Eigen::Vector2d, 3>> corners;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

/// `texel`, > 0, is the resolution at which overlaps are detected; input units.
std::vector<Chart> make_charts(const Mesh& mesh, double texel);

}  // namespace transformesh
