/// Snaps each vertex to the grid of the floating-point numbers at its largest coordinate (paper
/// 4.3). If magnitudes are extreme in every direction, the digits below that grid mean nothing for
/// the vertex, but make slivers that intersect again after every rounding.
#pragma once

#include "clean/rounding/displacement.h"

namespace transformesh {

/// Moves every vertex to the nearest point of its own grid, or of one that is so many times
/// coarser, a power of two: within .87 of its steps. Returns how far.
Displacement snap_to_vertex_grids(Mesh& mesh, Scalar type, double coarser);

}  // namespace transformesh
