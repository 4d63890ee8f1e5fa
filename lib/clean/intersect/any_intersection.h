/// Tests whether a mesh has self-intersections, as intersect.h defines them; stops at the first
/// self-intersection found. In meshes of more than 20000 faces, the search first takes 1024 sampled
/// faces with all faces near them. If these do not intersect, all faces are searched, so the answer
/// is exact. The sample usually suffices if some faces in a thousand intersect. Cost: O(n), mostly
/// one visit of each vertex and face, if the sample intersects. Otherwise the cost is that of
/// find_intersections() plus a third. Parallel; deterministic.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

bool has_intersections(const Mesh& mesh, const Progress& progress = Progress());

}  // namespace transformesh
