/// Removes thin cells of an arrangement (paper 4.3). The pieces divide space into cells (Zhou,
/// Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016). A cell
/// between two planes at a distance of a few grid steps has no significant shape. Hence it is
/// counted as inside or as outside, depending on which choice leaves less surface. This removes
/// thin sheets and gaps that rounding would make intersect repeatedly. The surface moves by at most
/// the thickness of the cells. Deterministic. O(n log n) for n pieces.
#pragma once

#include <cstdint>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/rounding/displacement.h"

namespace transformesh {

/// Definition of a thin cell: it is between two parallel planes whose distance is at most `steps`
/// grid steps at each corner of the cell. The grid step is half the spacing of floating-point
/// numbers at the corner, doubled several times (vertex_grids.h). The face around the cell with
/// most doublings determines how many times.
struct Thinness {
  double steps = 0;
  /// Number of times that the grid step was doubled, for each face of the arranged mesh.
  const std::vector<std::uint8_t>& levels;
  Scalar type = Scalar::float64;
};

/// Assigns each thin cell to the inside or to the outside, whichever leaves less surface. Then
/// `kept` selects the pieces between inside and outside, and pieces whose inside is on the other
/// side now are reversed. Returns true if a cell changed; then adds the thickness of the thickest
/// thin cell to `moved`.
bool give_thin_cells_away(Arrangement& arrangement, std::vector<char>& kept,
                          const Thinness& thinness, Displacement& moved);

}  // namespace transformesh
