/// Contracts singular edges that are too short to be split (paper 4.3). Stitching splits an edge of
/// more than two faces at its midpoint, if copies of its ends do not separate the sheets
/// (split_singular_edges.h). If the midpoint is rounded to one of the ends, every clean pass
/// creates the same faces without area. Such an edge is one or two spacings long. One end moves to
/// the other, and all faces along the edge vanish. A closed mesh stays closed. Deterministic. Cost:
/// O(n log n).
#pragma once

#include "clean/rounding/displacement.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

/// Contracts the edges. Equal positions must have equal indices. New vertices move to input
/// vertices; an edge between two input vertices is contracted only if `moves_input` is set.
/// Collapsed faces have two corners at one position. Returns true if a vertex moved; adds the
/// displacement to `moved`.
bool contract_unsplittable_edges(Assembly& assembly, bool moves_input, Scalar type,
                                 Displacement& moved);

}  // namespace transformesh
