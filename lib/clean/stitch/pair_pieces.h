/// Pairs the kept pieces of an arrangement across edges (paper 3.3). Most edges are between two
/// faces that were not cut and are both kept. These are paired as in the welded mesh.
/// pair_across_inside() (pair_halfedges.h) pairs the pieces at all other edges. Cost: O(n) with a
/// small constant, plus that of pair_across_inside() for the pieces at the other edges. Parallel;
/// deterministic.
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

/// Returns the opposite halfedges in a mesh of the kept pieces only. The `count` kept pieces are
/// renumbered from 0, in their order.
std::vector<Index> opposites_of_kept(const RawVector<Index>& opposite,
                                     const std::vector<char>& kept, std::size_t count);

}  // namespace transformesh
