/// A grid for every vertex: that of the numbers at its largest coordinate (paper 4.3). What lies
/// below says nothing at the place of the vertex, but where magnitudes are extreme in every
/// direction it makes slivers that intersect anew after every rounding.
#pragma once

#include "clean/rounding/displacement.h"

namespace transformesh {

/// Moves every vertex to the nearest point of its own grid, or of one that is so many times
/// coarser, a power of two: within .87 of its steps. Returns how far.
Displacement snap_to_vertex_grids(Mesh& mesh, Scalar type, double coarser);

}  // namespace transformesh
