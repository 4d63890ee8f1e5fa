/// Patches of an arrangement: sets of pieces that are connected across edges of exactly two pieces.
/// They are the parts of the surface between intersection curves and borders (paper 3.2.2). In a
/// closed mesh, the winding number in front of a patch is constant. Cost: O(n log n). Exact;
/// deterministic.
///
/// Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG
/// 35(4), 2016. Departures: a cell of space is represented by the set of patch sides on its
/// boundary. If a component is inside another one, the cells between them are not joined here.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "clean/arrange/arrange.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"

namespace transformesh {

class Patches {
 public:
  explicit Patches(const Arrangement& arrangement);

  /// Patch of each piece; no_index if the piece's multiplicity is 0, because its coincident faces
  /// cancel out.
  std::vector<Index> patch_of;
  std::vector<std::vector<Index>> pieces;  ///< pieces of each patch

  std::size_t size() const { return pieces.size(); }

 private:
  bool is_inner_edge(std::span<const Index> halfedges) const;
  void number_patches(const Edges& edges);
  void collect_patch(Index first, const std::vector<Index>& neighbor);
  const Arrangement& arrangement_;
};

/// Function that returns true if `halfedges` belong to all pieces at an edge, and false if the
/// arrangement lacks some of these pieces.
using IsWholeEdge = std::function<bool(std::span<const Index> halfedges)>;

/// Joins the sides of patches that bound the same cell of space next to a common edge. Side 2 *
/// patch is in front of a patch, side 2 * patch + 1 behind it. Edges for which `is_whole` returns
/// false are skipped. If `is_whole` is empty, no edge is skipped.
DisjointSets join_sides_around_edges(const Arrangement& arrangement, const Patches& patches,
                                     const IsWholeEdge& is_whole = {});

/// Sets the `kept` entries of pieces whose patch has the inside on one side and the outside on the
/// other. Reverses these pieces if necessary, so that the inside is behind them. Clears the `kept`
/// entries of other patches. `is_inside` has an entry for each side of each patch: 0, 1, or another
/// value for unknown. Patches with an unknown side do not change.
void keep_boundary(Arrangement& arrangement, const Patches& patches,
                   const std::vector<char>& is_inside, std::vector<char>& kept);

}  // namespace transformesh
