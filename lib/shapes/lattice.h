/// Marching on the tetrahedra of a body-centered cubic lattice.
#pragma once

#include "shapes/implicit.h"

namespace transformesh::shapes {

/// Returns the boundary of the lattice's tetrahedra inside the solid, cut at the zero set of its
/// function. `spacing` is half the edge of the cubes. Closed and oriented; a manifold if the
/// lattice resolves the solid. Each `variant` places the lattice differently. O(faces).
Mesh march(const ImplicitSolid& solid, double spacing, unsigned variant);

}  // namespace transformesh::shapes
