/// Removes components of which nothing can be meshed with edges of the wanted length (paper 5.1.2).
#pragma once

#include "remesh/halfedges/editable_mesh.h"
#include "transformesh/remesh.h"

namespace transformesh {

/// Removes every component of which all of these are small: each edge is shorter than `edge`, the
/// absolute volume is below pi/6 edge^3 (the paper's criterion), and the second longest side of a
/// box along its principal axes is shorter than `edge`. A plate that is wider than that stays,
/// however thin it is. `edge` is a factor of the component's mean size if the mesh has sizes. With
/// `keep_border` components with a border stay. The volume of a component with a border is that of
/// the cone from one of its vertices.
RemeshResult::RemovedComponents remove_small_components(EditableMesh& mesh, double edge,
                                                        bool keep_border);

}  // namespace transformesh
