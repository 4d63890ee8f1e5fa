/// Decides whether the two patches that close a slit (twin_patches.h) meet no other part of the
/// surface. The slab is the space between both patches. It becomes outside if a bridge is cut, and
/// inside if a tunnel is closed. If a cavity, another body or another handle reached into the slab,
/// the cut would open, join or remove it.
///
/// Faces within two rings of the loop are ignored: clean() removes their intersections with the
/// patches, which has no other effect. Intersections are decided exactly. Cost: O(n) for the first
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
  /// Keeps references to both arguments. Slits are tested against the faces that the mesh has at
  /// the first call of is_free().
  SlitClearance(const Mesh& mesh, const HalfedgeStars& stars) : mesh_(mesh), stars_(stars) {}

  /// True if the patches and the slab of a slit meet neither the surface nor a recorded slit.
  bool is_free(const std::vector<Index>& loop, const SlitSides& sides, const ClosedSlit& slit);
  /// Records a slit, against which later slits are tested. Call this before the mesh is cut open
  /// along the loop.
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
