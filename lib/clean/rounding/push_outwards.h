/// Pushes vertices outwards by a few spacings of numbers (paper 4.3): two sheets of a thin sheet
/// that rounding made intersect come apart again, while sheets on both sides of a gap overlap, so
/// that cleaning closes the gap. Of the 26 directions that a grid has, a vertex takes that which
/// leads farthest outside of all faces around it, and stays where there is none. Deterministic. O(n
/// log k) for n faces and k vertices of those named.
#pragma once

#include <vector>

#include "clean/rounding/close_vertices.h"

namespace transformesh {

/// Moves vertices of the faces; those of the input only if the rule says so. All vertices at one
/// position move together. Returns how far a vertex moved.
Displacement push_outwards(Assembly& assembly, const std::vector<Index>& faces,
                           const MoveRule& rule, const Spacings& spacing);

}  // namespace transformesh
