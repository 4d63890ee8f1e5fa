/// Pairs the kept pieces (triangles) of an arrangement across edges (paper 3.3). Most edges are
/// between two faces that were not cut and are both kept. These are paired as in the welded mesh,
/// whose faces share vertices at equal positions. pair_across_inside() (pair_halfedges.h) pairs the
/// pieces at all other edges. Cost: O(n) with a small constant, plus that of pair_across_inside()
/// for the pieces at the other edges. Parallel; deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "support/raw_vector.h"

namespace transformesh {

struct PiecePairs {
  /// For each halfedge 3 * piece + i, its opposite halfedge or no_index.
  RawVector<Index> opposite;
  bool has_singular_edges = false;  ///< true if an edge has more than two pieces that are kept
};

/// Pairs the halfedges of the pieces (triangles of the arrangement) with a nonzero entry in `kept`.
PiecePairs pair_pieces(const Arrangement& arrangement, const std::vector<char>& kept);

/// Returns the opposite halfedges after only the kept pieces (triangles) remain. These `count`
/// pieces are renumbered from 0, in their order.
std::vector<Index> opposites_of_kept(const RawVector<Index>& opposite,
                                     const std::vector<char>& kept, std::size_t count);

}  // namespace transformesh
