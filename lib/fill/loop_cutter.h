/// Cuts a closed surface along loops of edges and caps both sides. The surface is cut open along a
/// loop (slit.h), and the vertices on both sides move away from the cut by about a third of an
/// edge. Each side is closed by a patch (twin_patches.h) that meets no other part of the surface
/// (slit_clearance.h). Loops that one LoopCutter cuts have no vertices near each other, so that the
/// surface around a loop is unchanged when the loop is cut. Cost: O(n) for the constructor, and
/// that of the patches. Deterministic.
#pragma once

#include <vector>

#include "fill/slit_clearance.h"

namespace transformesh {

enum class CutOutcome {
  done,
  no_patch,   ///< not cut: no patches fit
  in_the_way  ///< not cut: the patches would meet another part of the surface
};

class LoopCutter {
 public:
  /// Precondition: `mesh` is a closed oriented manifold, and `opposites` are its opposite
  /// halfedges. Keeps a reference to the mesh, which cut() changes.
  LoopCutter(Mesh& mesh, Scalar coordinate, std::vector<Index> opposites);

  /// Returns the connectivity of the surface before the first cut. The connectivity of a vertex
  /// stays valid if the vertex is not near a cut.
  const HalfedgeStars& stars() const { return stars_; }
  /// True if no vertex of the loop is on a loop that was tried, or next to a loop that was cut.
  bool has_room(const std::vector<Index>& loop) const;
  /// Cuts along a loop. Precondition: has_room(loop) is true. The mesh changes only if the outcome
  /// is `done`.
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
