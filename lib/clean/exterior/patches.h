/// The patches of an arrangement: pieces connected across edges at which nothing else meets them,
/// so the parts of the surface between intersection curves and borders (paper 3.2.2). Across a
/// patch of a closed mesh the winding number w in front is constant; around an intersection curve
/// it passes from patch to patch (paper 3.2.3). Cost: O(n log n). Exact; deterministic. Reference:
/// Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016.
#pragma once

#include <span>
#include <vector>

#include "clean/arrange/arrange.h"
#include "mesh/edges.h"

namespace transformesh {

class Patches {
 public:
  explicit Patches(const Arrangement& arrangement);

  /// Two patches that bound one region beside a common curve, where w must agree.
  struct Relation {
    Index patch;
    int offset;  ///< w in front of that patch, less w in front of this one
  };

  std::vector<Index> patch_of;                   ///< per piece; no_index for multiplicity 0
  std::vector<std::vector<Index>> pieces;        ///< of each patch
  std::vector<std::vector<Relation>> relations;  ///< of each patch with others

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
