/// Contracts singular edges that are too short to be split (paper 4.3). Stitching splits an edge of
/// more than two faces in its middle where copies of its ends do not part the sheets
/// (split_singular_edges.h). If the middle of an edge is rounded to one of its ends, every pass
/// of cleaning makes the same faces without area. The edge is one or two spacings of numbers long.
/// One end moves to the other, so that all faces along the edge vanish: identifying two points
/// keeps what is closed closed. Deterministic. Cost: O(n log n).
#pragma once

#include "clean/rounding/displacement.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

/// Equal positions have equal indices. New vertices move to vertices of the input; an edge between
/// two of these is contracted only if they may move. Vanished faces have two corners at one
/// position. Returns whether a vertex moved, and notes how far.
bool contract_unsplittable_edges(Assembly& assembly, bool moves_input, Scalar type,
                                 Displacement& moved);

}  // namespace transformesh
