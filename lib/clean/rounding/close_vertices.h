/// Merges vertices that are closer than a few spacings of numbers (paper 4.3): what rounding all
/// but unites would only make slivers. References: Halperin & Packer, "Iterated snap rounding",
/// Computational Geometry 23(2), 2002; Valque & Lazard, "Removing self-intersections in 3D meshes
/// while preserving floating-point coordinates", 2025.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "clean/rounding/local_distance.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

struct MoveRule {
  double spacings = 1;       ///< how far along every axis, in spacings at the vertex
  bool moves_input = false;  ///< input vertices may move; else they only attract new ones
};

/// Moves vertices of the faces that are this close to others of them to the position of those;
/// input vertices attract before new ones do. All vertices at one position move together, even
/// those of other faces: else the surface would tear. Faces that change become new. Returns how far
/// a vertex moved. O(n + k log k) for k vertices of the faces; deterministic.
Displacement merge_close_vertices(Assembly& assembly, const std::vector<Index>& faces,
                                  const MoveRule& rule, const Spacings& spacing);

/// The positions of the corners of some faces, each once, and moves of them.
class CornerPositions {
 public:
  CornerPositions(const Mesh& mesh, const std::vector<Index>& faces);
  const std::vector<Vec3>& positions() const { return positions_; }
  /// The number of a position; no_index where it is none of them.
  Index find(const Vec3& position) const;
  /// Per position, the spacings that count at it along each axis, by the faces of this.
  std::vector<Vec3> spacings(const Mesh& mesh, const std::vector<Index>& faces,
                             const Spacings& spacing) const;
  /// Gives every vertex at one of the positions the new one; faces that change become new.
  void move(Assembly& assembly, const std::vector<Vec3>& to) const;

 private:
  std::vector<Vec3> positions_;   ///< sorted
  std::vector<Index> number_of_;  ///< per vertex of the faces
};

}  // namespace transformesh
