/// Finds the faces that may meet others at all, by the cells of a grid.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Of equal faces the first, but for those that are far from any face of another region,
/// or of none (intersection_free_regions.h): these meet nothing. Where most have no region, all of
/// them. Ascending. O(n); deterministic.
std::vector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> regions);

}  // namespace transformesh
