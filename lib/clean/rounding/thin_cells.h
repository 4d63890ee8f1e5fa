/// Gives thin cells of an arrangement away (paper 4.3). The pieces part space into cells
/// (Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016).
/// A cell that lies between two planes a few steps of their grids apart is no matter of shape,
/// whether it is inside or outside: it goes to the side that leaves less surface. So thin sheets
/// and gaps vanish that rounding would make intersect again and again, while nothing moves that is
/// farther than that from the surface. Deterministic. O(n log n) for n pieces.
#pragma once

#include <cstdint>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/rounding/displacement.h"

namespace transformesh {

/// A cell is thin if it lies between two planes that are at most this far apart at each of its
/// corners. Distances are in steps of grids (vertex_grids.h) of the coarsest face around the cell.
struct Thinness {
  double steps = 0;
  const std::vector<std::uint8_t>& levels;  ///< doublings of grids, per face of the arranged mesh
  Scalar type = Scalar::float64;
};

/// Changes which pieces are kept, and turns those over that bound a body with their other side now.
/// Returns whether a cell was given away, and notes the thickness of the thickest thin cell then.
bool give_thin_cells_away(Arrangement& arrangement, std::vector<char>& kept,
                          const Thinness& thinness, Displacement& moved);

}  // namespace transformesh
