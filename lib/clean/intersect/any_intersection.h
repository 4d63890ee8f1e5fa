/// Tests whether a mesh has self-intersections, as intersect.h defines them; stops at the first
/// self-intersection found. In a mesh of more than 4096 faces, 1024 sampled faces are searched
/// first, then these and all faces near them. If no two of these faces intersect, all faces are
/// searched, so the answer is exact. The samples suffice if each face intersects a few hundredths
/// of all faces, and the faces near them if a few faces in a thousand intersect. Cost: O(n), mostly
/// one visit of each vertex and face, if a search of samples finds an intersection. Otherwise the
/// cost is that of find_intersections() plus a third. Parallel; deterministic.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

bool has_intersections(const Mesh& mesh, const Progress& progress = Progress());

}  // namespace transformesh
