/// Cuts a closed surface along loops of edges and caps both sides. The surface is slit (slit.h),
/// and both sides are drawn back by a third of an edge. Each side is closed by a patch
/// (twin_patches.h) that meets no other part of the surface (slit_clearance.h). Loops that one
/// LoopCutter cuts have no vertices near each other, so that each loop finds an unchanged surface.
/// Cost: O(n) to make, and that of the patches. Deterministic.
#pragma once

#include <vector>

#include "fill/slit_clearance.h"

namespace transformesh {

enum class CutOutcome {
  done,
  no_patch,   ///< no two patches fit
  in_the_way  ///< the patches would intersect another part of the surface
};

class LoopCutter {
 public:
  /// Pre: `mesh` is a closed oriented manifold, and `opposites` are its opposite halfedges. Keeps a
  /// reference to the mesh, to which cuts add faces.
  LoopCutter(Mesh& mesh, Scalar coordinate, std::vector<Index> opposites);

  /// Returns the connectivity before the first cut. It stays valid for vertices that are not near a
  /// cut.
  const HalfedgeStars& stars() const { return stars_; }
  /// True if no vertex of the loop is on a loop that was tried, or next to a loop that was cut.
  bool has_room(const std::vector<Index>& loop) const;
  /// Cuts along a loop. Pre: has_room(loop). The mesh does not change unless the outcome is `done`.
  CutOutcome cut(const std::vector<Index>& loop);

 private:
  void take_room(const std::vector<Index>& loop);

  Mesh& mesh_;
  Scalar coordinate_;
  HalfedgeStars stars_;
  SlitClearance clearance_;
  std::vector<char> is_near_;  ///< 1 for each vertex on a tried loop, or next to a cut loop
};

}  // namespace transformesh
