/// Regions: parts of a mesh in which no two faces meet beyond what they share, told without looking
/// at pairs. A region is a disk of faces that all look one way along an axis, and whose outline,
/// seen along it, is simple. So many faces lie over each other as the outline goes around a point,
/// which is once; and where two touched from beside each other, their outlines would. Reference:
/// Volino & Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized surface
/// animations using geometrical shape regularity", Computer Graphics Forum 13(3), 1994.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct IntersectionFreeRegions {
  std::vector<Index> of_face;  ///< no_index where there is none
  std::vector<char> is_seam;   ///< per point: not all faces around it are in one region
};

/// O(n); deterministic.
IntersectionFreeRegions find_intersection_free_regions(const WeldedMesh& welded);

}  // namespace transformesh
