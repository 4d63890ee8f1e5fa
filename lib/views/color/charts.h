/// Divides a surface into planar charts. Each chart is projected along its mean normal. The
/// projection shrinks lengths by a factor of at most 2, except on a few faces. Faces of a chart do
/// not overlap by more than a texel, a pixel of the texture.
///
/// A chart grows across edges with two faces. It begins at the first face that is in no chart yet.
/// Every face belongs to a chart. O(n) except for sorting; deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct Chart {
  std::vector<Index> faces;
  /// Corners of each face in the plane, in input units. The lower corner of the chart's bounding
  /// box is at (0, 0). The chart is rotated such that this box is small, and wider than high.
  std::vector<std::array<Eigen::Vector2d, 3>> corners;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

/// Divides the mesh into charts. `texel`, > 0, is the resolution at which overlaps of faces are
/// detected; input units.
std::vector<Chart> make_charts(const Mesh& mesh, double texel);

}  // namespace transformesh
