/// Cuts a surface into charts that lie flat: each is projected along its mean normal, so that
/// lengths shrink by at most 2 but for few faces, and no two faces of one overlap by more than a
/// texel does.
///
/// Charts grow over edges of two faces from the first face that has none. O(n) but for sorting; no
/// face is left out. Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct Chart {
  std::vector<Index> faces;
  /// Of each face the corners in the plane, in input units, in a frame in which the chart's box
  /// begins at 0; turned so that the box is small, and wider than high.
  std::vector<std::array<Eigen::Vector2d, 3>> corners;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

/// `texel`, > 0, is the length at which overlaps are looked for.
std::vector<Chart> make_charts(const Mesh& mesh, double texel);

}  // namespace transformesh
