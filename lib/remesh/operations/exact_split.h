/// Splits edges at positions that are tested exactly.
#pragma once

#include <vector>

#include "remesh/guards/exact_guard.h"

namespace transformesh {

/// Splits an edge only if that adds no self-intersection and no face without area. Rounding moves a
/// midpoint off its edge by up to half a spacing in each coordinate. If this causes contact with
/// slivers or other sheets, other positions are tried. Edges with equal end positions, such as
/// copies of a singular edge, are split together.
class ExactSplitter {
 public:
  ExactSplitter(EditableMesh& mesh, ExactGuard& guard) : mesh_(mesh), guard_(guard) {}

  /// Returns the new vertices; there are several only if the edge has copies. Empty if no position
  /// is possible, or if one of the copies is a border and `keep_border` is set.
  std::vector<Index> split(Index halfedge, bool keep_border);

 private:
  void find_copies(Index halfedge);
  void gather_replaced();
  bool is_taken(const Vec3& position) const;
  bool try_position(const Vec3& position);
  Index split_at(Index halfedge, const Vec3& position);

  EditableMesh& mesh_;
  ExactGuard& guard_;
  std::vector<Index> copies_;    ///< a halfedge of each edge to split
  std::vector<Index> replaced_;  ///< faces at the edges in `copies_`
  std::vector<Triangle> made_;
};

}  // namespace transformesh
