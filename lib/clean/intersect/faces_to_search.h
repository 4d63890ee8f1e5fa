/// Selects the faces that may intersect other faces, by a uniform grid.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"
#include "support/raw_vector.h"

namespace transformesh {

/// Returns the faces to search, in ascending order. Only the first of several faces with the same
/// three points is returned. A face of an intersection-free region (intersection_free_regions.h) is
/// left out if all faces near it belong to the same region. If more than half of the faces have no
/// region, no face is left out for this reason. O(n); parallel; deterministic.
RawVector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> regions);

}  // namespace transformesh
