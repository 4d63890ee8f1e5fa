/// Removes components that are too small for edges of the wanted length (paper 5.1.2).
#pragma once

#include "remesh/halfedges/editable_mesh.h"
#include "transformesh/remesh.h"

namespace transformesh {

/// Removes every component that satisfies three conditions:
/// - All edges are shorter than `edge`.
/// - The absolute volume is below pi/6 edge^3, which is the paper's criterion.
/// - The second longest side of a box along its principal axes is shorter than `edge`. A wider
/// plate thus stays, however thin it is. If the mesh has sizes, `edge` is a factor of the
/// component's mean size. With `keep_border`, components with a border stay. The volume of a
/// component with a border is that of the cone from one of its vertices.
RemeshResult::RemovedComponents remove_small_components(EditableMesh& mesh, double edge,
                                                        bool keep_border);

}  // namespace transformesh
