/// Removes components too small to be surface (paper 5.1.2).
#pragma once

#include "tm/remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Removes every component whose edges are all shorter than `edge` and whose volume is, whatever
/// its sign, below pi/6 edge^3; with keep_border those with a border stay. The volume of a
/// component with a border is that of the cone from one of its vertices. Returns how many went.
std::size_t remove_small_components(EditableMesh& mesh, double edge, bool keep_border);

}  // namespace transformesh
