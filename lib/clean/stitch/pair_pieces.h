/// Pairs the kept pieces of an arrangement across edges (paper 3.3). Most edges are between two
/// whole faces that stay: their pieces are paired as in the welded mesh. pair_across_inside()
/// decides on the other edges. Cost: O(n) with a small constant, and as in pair_halfedges.h for the
/// pieces at the other edges. Parallel; deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "support/raw_vector.h"

namespace transformesh {

struct PiecePairs {
  RawVector<Index> opposite;        ///< opposite of each halfedge 3 * piece + i, or no_index
  bool has_singular_edges = false;  ///< true if an edge has more than two kept pieces
};

/// Pairs the pieces with a nonzero `kept` entry.
PiecePairs pair_pieces(const Arrangement& arrangement, const std::vector<char>& kept);

/// Returns the opposites of the kept pieces, which are numbered in their order from 0 to `count`.
std::vector<Index> opposites_of_kept(const RawVector<Index>& opposite,
                                     const std::vector<char>& kept, std::size_t count);

}  // namespace transformesh
