/// Removes components that are too thin for edges of the wanted length, however long they are.
#pragma once

#include "remesh/halfedges/editable_mesh.h"
#include "transformesh/remesh.h"

namespace transformesh {

/// Removes every closed component that has an edge shorter than `edge` and less area than a sphere
/// of that diameter. Such a component has less volume than the sphere (isoperimetric inequality).
/// A flow that tears a surface leaves long thin components: cylinders and disks thinner than `edge`
/// but longer or wider than it, which remove_small_components() keeps. If the mesh has sizes,
/// `edge` is a factor of the size.
RemeshResult::RemovedComponents remove_thin_components(EditableMesh& mesh, double edge);

}  // namespace transformesh
