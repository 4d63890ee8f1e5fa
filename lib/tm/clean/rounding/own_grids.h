/// A grid for every vertex: that of the numbers at its largest coordinate (paper 4.3). What lies
/// below says nothing at the place of the vertex, but where magnitudes are extreme in every
/// direction it makes slivers that cross anew after every rounding.
#pragma once

#include "tm/clean/rounding/displacement.h"

namespace transformesh {

/// Moves every vertex to the nearest point of its own grid, within .87 spacings. Returns how far.
Displacement snap_to_own_grids(Mesh& mesh, Scalar type);

}  // namespace transformesh
