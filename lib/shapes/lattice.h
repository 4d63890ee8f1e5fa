/// Marching on a body-centered cubic lattice.
#pragma once

#include "shapes/implicit.h"

namespace transformesh::shapes {

/// The boundary of the lattice's tetrahedra inside the solid, cut where its function is zero.
/// `spacing` is half the edge of the cubes. Closed and oriented; a manifold where the solid is
/// resolved. Each `variant` is a different placement of the lattice. O(faces).
Mesh march(const ImplicitSolid& solid, double spacing, unsigned variant);

}  // namespace transformesh::shapes
