/// The sheets of an open mesh that lie within its bodies (beyond paper 4.6), such as a wall that
/// two bodies share and that is given only once: with it winding numbers contradict each other,
/// without it the surface around both is closed.
///
/// The surfaces part space into cells. From the unbounded cell, where it is 0, the winding number
/// passes from cell to cell, nearest cells first. A sheet is enclosed where all of it contradicts
/// the cells on both of its sides, both are within the body, and its removal leaves no edge with a
/// border. So a sheet outside of bodies, or in a body with a hole, is never enclosed.
/// Cost: that of an arrangement for every round of removals, of which there is mostly one.
/// Deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"

namespace transformesh {

/// Marks the welded faces of such sheets. Within a body is where the winding number is >= winding
/// level.
std::vector<char> find_enclosed_sheets(const Arrangement& arrangement, int winding_level,
                                       const Progress& progress);

}  // namespace transformesh
