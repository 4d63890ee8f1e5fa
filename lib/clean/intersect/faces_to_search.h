/// Which faces may meet others at all: told by the cells of a grid.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Of equal faces the first, but for those that are far from any face of another zone,
/// or of none (zones.h): these meet nothing. Where most have no zone, all of them. Ascending. O(n);
/// deterministic.
std::vector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> zones);

}  // namespace transformesh
