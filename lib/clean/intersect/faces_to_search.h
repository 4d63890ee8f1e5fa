/// Selects the faces that may intersect others, by a uniform grid.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"
#include "support/raw_vector.h"

namespace transformesh {

/// Returns the first copy of each face, in ascending order, without faces that cannot intersect
/// others. A face of an intersection-free region (intersection_free_regions.h) is left out if no
/// other region and no face without region is near. If more than half of the faces have no region,
/// no face is left out. O(n); parallel; deterministic.
RawVector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> regions);

}  // namespace transformesh
