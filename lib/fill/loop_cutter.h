/// Cuts a closed surface along loops of edges and caps both sides. The surface is slit (slit.h),
/// and both sides are drawn back by a third of an edge. Each is closed by a patch (twin_patches.h)
/// that keeps clear of all other parts (slit_clearance.h). Loops that one object cuts keep clear of
/// each other, so that each finds the surface as it was. Cost: O(n) to make, and that of the
/// patches. Deterministic.
#pragma once

#include <vector>

#include "fill/slit_clearance.h"

namespace transformesh {

enum class CutOutcome {
  done,
  no_patch,   ///< no two patches fit
  in_the_way  ///< the patches would reach into another part of the surface
};

class LoopCutter {
 public:
  /// Pre: a closed oriented manifold, and its opposites. Keeps a reference to the mesh, which
  /// grows.
  LoopCutter(Mesh& mesh, Scalar coordinate, std::vector<Index> opposites);

  /// Connectivity before the first cut, which stays right away from all cuts.
  const HalfedgeStars& stars() const { return stars_; }
  /// Whether no vertex of the loop is at a loop that was tried, or next to one that was cut.
  bool has_room(const std::vector<Index>& loop) const;
  /// Pre: has_room(). The mesh stays as it is unless the outcome is `done`.
  CutOutcome cut(const std::vector<Index>& loop);

 private:
  void take_room(const std::vector<Index>& loop);

  Mesh& mesh_;
  Scalar coordinate_;
  HalfedgeStars stars_;
  SlitClearance clearance_;
  std::vector<char> is_near_;  ///< per vertex before the first cut
};

}  // namespace transformesh
