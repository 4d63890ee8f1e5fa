/// The patches of an arrangement: pieces connected across edges at which nothing else meets them,
/// so the parts of the surface between intersection curves and borders (paper 3.2.2). Across a
/// patch of a closed mesh the winding number w in front is constant. Cost: O(n log n). Exact;
/// deterministic. Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid
/// geometry", ACM TOG 35(4), 2016.
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

  std::vector<Index> patch_of;             ///< per piece; no_index for multiplicity 0
  std::vector<std::vector<Index>> pieces;  ///< of each patch

  std::size_t size() const { return pieces.size(); }

 private:
  bool is_inner_edge(std::span<const Index> halfedges) const;
  void number_patches(const Edges& edges);
  void collect_patch(Index first, const std::vector<Index>& neighbor);
  const Arrangement& arrangement_;
};

/// Says whether the pieces at an edge, named by their halfedges, are all that there are.
using IsWholeEdge = std::function<bool(std::span<const Index> halfedges)>;

/// Joins the sides of patches that bound one cell of space beside a common edge: 2 * patch is the
/// side in front of a patch, 2 * patch + 1 that behind it. Edges that are not whole join nothing;
/// without the function all edges are whole.
DisjointSets join_sides_around_edges(const Arrangement& arrangement, const Patches& patches,
                                     const IsWholeEdge& is_whole = {});

/// Marks the pieces of patches that part what is inside from what is not, turns them so that the
/// inside is behind them, and unmarks those of other patches. `is_inside` is per side; at a patch
/// with a side that is neither 0 nor 1, nothing changes.
void keep_boundary(Arrangement& arrangement, const Patches& patches,
                   const std::vector<char>& is_inside, std::vector<char>& kept);

}  // namespace transformesh
