/// Whether a mesh has self-intersections at all, by the definition of intersect.h: a search that
/// ends with the first one it meets. Some faces, spread over the mesh, are searched with all that
/// may touch them; where these do not meet, everything is searched. So the answer is exact, and yes
/// is quick if some faces in a thousand intersect.
/// Cost: O(n), mostly a look at each vertex and each face, where the first search finds something;
/// else as find_intersections and a third more. Parallel; deterministic.
#pragma once

#include "mesh/mesh.h"
#include "support/progress.h"

namespace transformesh {

bool has_intersections(const Mesh& mesh, const Progress& progress = Progress());

}  // namespace transformesh
