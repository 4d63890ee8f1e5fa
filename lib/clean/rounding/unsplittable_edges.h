/// Contracts singular edges (edges of more than two faces) that are too short to be split (paper
/// 4.3). Stitching duplicates the ends of a singular edge. If this does not separate the sheets
/// that meet there, stitching splits the edge at its midpoint (split_singular_edges.h). If the
/// midpoint is rounded to one of the ends, every clean pass creates the same faces without area.
/// This happens to edges of one or two spacings of coordinates. One end of such an edge moves to
/// the other end, and all faces at the edge vanish. A closed mesh stays closed. Deterministic.
/// Cost: O(n log n).
#pragma once

#include "clean/rounding/displacement.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

/// Contracts edges of more than two faces that are too short to be split. Equal positions must have
/// equal indices. If one end is a new vertex and the other end is an input vertex, the new vertex
/// moves. An edge between two input vertices is contracted only if `moves_input` is set. Faces that
/// vanish stay in the list, with two corners at the same position. Returns true if a vertex moved;
/// adds the displacement to `moved`.
bool contract_unsplittable_edges(Assembly& assembly, bool moves_input, Scalar type,
                                 Displacement& moved);

}  // namespace transformesh
