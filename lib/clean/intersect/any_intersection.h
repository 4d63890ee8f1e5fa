/// Tests whether a mesh has self-intersections, as intersect.h defines them; stops at the first
/// self-intersection found. In a mesh of more than 20000 faces, the first search is restricted to
/// 1024 sampled faces and all faces near them. If no two of these faces intersect, all faces are
/// searched, so the answer is exact. The first search usually suffices if a few faces in a thousand
/// intersect. Cost: O(n), mostly one visit of each vertex and face, if the first search finds an
/// intersection. Otherwise the cost is that of find_intersections() plus a third. Parallel;
/// deterministic.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

bool has_intersections(const Mesh& mesh, const Progress& progress = Progress());

}  // namespace transformesh
