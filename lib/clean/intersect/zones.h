/// Zones: parts of a mesh in which no two faces meet beyond what they share, told without looking
/// at pairs. A zone is a disk of faces that all look one way along an axis, and whose outline, seen
/// along it, is simple. So many faces lie over each other as the outline goes around a point, which
/// is once; and where two touched from beside each other, their outlines would. Reference: Volino &
/// Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized surface
/// animations using geometrical shape regularity", Computer Graphics Forum 13(3), 1994.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct Zones {
  std::vector<Index> of_face;  ///< no_index where there is none
  std::vector<char> is_seam;   ///< per point: not all faces around it are in one zone
};

/// O(n); deterministic.
Zones find_zones(const WeldedMesh& welded);

}  // namespace transformesh
