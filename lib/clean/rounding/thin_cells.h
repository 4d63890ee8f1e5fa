/// Gives thin cells of an arrangement away (paper 4.3). The pieces part space into cells
/// (Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016).
/// A cell that lies between two planes a few spacings of numbers apart is no matter of shape,
/// whether it is inside or outside: it goes to the side that leaves less surface. So thin sheets
/// and gaps vanish that rounding would make intersect again and again, while nothing moves that is
/// farther than that from the surface. Deterministic. O(n log n) for n pieces.
#pragma once

#include <optional>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/rounding/displacement.h"
#include "clean/rounding/local_distance.h"

namespace transformesh {

/// Changes which pieces are kept, and turns those over that bound a body with their other side now.
/// Thin is a cell between two planes that are at most `spacings` apart at each of its corners.
/// Where faces of the arranged mesh are marked, only cells beside them go.
/// Returns the thickness of the thickest thin cell where one was given away.
std::optional<Displacement> give_thin_cells_away(Arrangement& arrangement, std::vector<char>& kept,
                                                 double spacings, const Spacings& spacing,
                                                 const std::vector<char>& marked_faces = {});

}  // namespace transformesh
