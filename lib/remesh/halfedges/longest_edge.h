/// The longest edge of a mesh.
#pragma once

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Returns the length of the longest edge; 0 if there is none. O(n), on all allowed threads.
double longest_edge_of(const EditableMesh& mesh);

}  // namespace transformesh
