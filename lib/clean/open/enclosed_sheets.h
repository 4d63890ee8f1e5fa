/// Finds sheets of an open mesh that are inside its bodies (beyond paper 4.6). An example is a
/// single wall between two bodies, which both bodies share. With the wall, winding numbers
/// contradict each other; without it, the surface around both bodies is closed.
///
/// A sheet is a set of faces that are connected across edges of two faces. The patches of the
/// arrangement (exterior/patches.h) divide space into cells. The winding number is 0 in the
/// unbounded cell and is propagated from cell to cell, in breadth-first order. A sheet is enclosed
/// if three conditions hold. For each of its patches, the difference of the winding numbers of the
/// cells on both sides is not the multiplicity of the patch. Both cells are inside the body.
/// Removing the sheet leaves no border edge. Hence a sheet outside of bodies, or in a body with a
/// hole, is never enclosed. Cost: one arrangement per round of removals; usually there is one
/// round. Deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"

namespace transformesh {

/// Marks the welded faces of enclosed sheets. A point is inside a body if its winding number is >=
/// winding level.
std::vector<char> find_enclosed_sheets(const Arrangement& arrangement, int winding_level,
                                       const Progress& progress);

}  // namespace transformesh
