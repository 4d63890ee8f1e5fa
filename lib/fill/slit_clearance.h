/// Decides whether a closed slit (twin_patches.h) meets no other part of the surface. The slab
/// between its two patches becomes outside if a bridge is cut, and inside if a tunnel is closed. A
/// cavity, another body or another handle that reaches into the slab would then be opened, joined
/// or removed.
///
/// Faces within two rings of the loop are ignored: clean() resolves their intersections with the
/// patches, and nothing else changes. Intersections are decided exactly. Cost: O(n) for the first
/// slit, then that of the faces near each slit. Deterministic.
#pragma once

#include <vector>

#include "fill/twin_patches.h"
#include "geometry/search/bvh.h"
#include "mesh/triangle.h"
#include "transformesh/measure.h"

namespace transformesh {

class SlitClearance {
 public:
  /// Keeps references. Slits are tested against the present faces of the mesh.
  SlitClearance(const Mesh& mesh, const HalfedgeStars& stars) : mesh_(mesh), stars_(stars) {}

  /// True if a slit meets neither the surface nor an earlier slit.
  bool is_free(const std::vector<Index>& loop, const SlitSides& sides, const ClosedSlit& slit);
  /// Records a slit. Call before the mesh is slit.
  void take(const std::vector<Index>& loop, const SlitSides& sides, const ClosedSlit& slit);

 private:
  std::vector<Triangle> surface_of(const std::vector<Index>& loop, const SlitSides& sides,
                                   const ClosedSlit& slit) const;
  std::vector<Triangle> others_near(const std::vector<Index>& loop, const Box& box);
  std::vector<Index> near_vertices(const std::vector<Index>& loop) const;

  const Mesh& mesh_;
  const HalfedgeStars& stars_;
  Bvh faces_;  ///< tree of the faces, built at the first call of is_free()
  std::vector<std::vector<Triangle>> taken_;
};

}  // namespace transformesh
