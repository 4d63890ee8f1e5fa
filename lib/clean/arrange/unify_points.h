/// One number for the equal points of all planes: those of the mesh keep theirs, and new ones
/// follow in the order in which the planes list them. Cost: O(k log k) for k points. Exact;
/// deterministic.
#pragma once

#include <vector>

#include "clean/arrange/cut_plane.h"

namespace transformesh {

struct UnifiedPoints {
  std::vector<std::vector<Index>> ids;  ///< per plane and point of it
  std::vector<ExactPoint> cut_points;   ///< the new ones
};

UnifiedPoints unify_points(const WeldedMesh& welded, const std::vector<PlaneCut>& cuts);

}  // namespace transformesh
