/// Patches: pieces of an arrangement that hang together across edges which a surface simply passes,
/// so between intersection curves and borders. What lies in front of one piece of a closed mesh
/// lies in front of all pieces of its patch (paper 3.2). Cost: O(n log n). Exact; deterministic.
#pragma once

#include <span>
#include <vector>

#include "tm/clean/arrange/arrange.h"
#include "tm/mesh/edges.h"

namespace transformesh {

class Patches {
 public:
  explicit Patches(const Arrangement& arrangement);

  /// Across a curve, w behind or before one patch equals w before or behind the next.
  struct Relation {
    Index patch;
    int offset;  ///< w in front of that patch, less w in front of this one
  };

  std::vector<Index> patch_of;             ///< per piece; no_index for pieces that cancel out
  std::vector<std::vector<Index>> pieces;  ///< of each patch
  std::vector<std::vector<Relation>> relations;

  std::size_t size() const { return pieces.size(); }

 private:
  bool is_inner_edge(std::span<const Index> halfedges) const;
  void number_patches(const Edges& edges);
  void collect_patch(Index first, const std::vector<Index>& neighbor);
  bool is_loose(const std::vector<Index>& sorted, std::size_t i) const;
  bool is_ambiguous(const std::vector<Index>& sorted) const;
  void relate_around(std::span<const Index> halfedges);
  void relate(Index a, Index b);

  const Arrangement& arrangement_;
};

}  // namespace transformesh
