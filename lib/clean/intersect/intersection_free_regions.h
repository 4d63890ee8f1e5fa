/// Regions of a mesh in which no two faces intersect, found without testing pairs. A region is a
/// disk of faces whose normals all point to one side along an axis, and whose outline, projected
/// along that axis, is a simple polygon. Then a line along the axis meets the region at most once.
/// Reference: Volino & Magnenat-Thalmann, "Efficient self-collision detection on smoothly
/// discretized surface animations using geometrical shape regularity", Computer Graphics Forum
/// 13(3), 1994.
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
