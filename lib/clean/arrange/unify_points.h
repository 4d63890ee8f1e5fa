/// Assigns the same number to equal points of different planes (sets of coplanar faces). Points of
/// the welded mesh keep their indices. New points follow in the order in which the planes list
/// them. Cost: O(k log k) for k points. Exact; deterministic.
#pragma once

#include <vector>

#include "clean/arrange/cut_plane.h"

namespace transformesh {

struct UnifiedPoints {
  std::vector<std::vector<Index>> ids;  ///< for each plane the numbers of its points
  std::vector<ExactPoint> cut_points;   ///< new points, in the order of their numbers
};

UnifiedPoints unify_points(const WeldedMesh& welded, const std::vector<PlaneCut>& cuts);

}  // namespace transformesh
