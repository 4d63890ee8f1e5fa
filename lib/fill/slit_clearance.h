/// Decides whether a slit that is closed and drawn apart (twin_patches.h) keeps clear of all other
/// parts of the surface. Between its two patches lies a slab that becomes outside, where a bridge
/// is cut through, or inside, where a tunnel is closed. A cavity or another body that reaches into
/// the slab would be opened, joined or swallowed by that, and so would another handle.
///
/// Faces within two rings of the loop are ignored: where they meet the patches, clean() resolves
/// it, and nothing else changes. Intersections are decided exactly. Cost: O(n) for the first
/// question, then that of the faces near the slit. Deterministic.
#pragma once

#include <vector>

#include "fill/twin_patches.h"
#include "geometry/search/bvh.h"
#include "mesh/triangle.h"
#include "transformesh/measure.h"

namespace transformesh {

class SlitClearance {
 public:
  /// Keeps references. The faces that the mesh has now are those of the surface.
  SlitClearance(const Mesh& mesh, const HalfedgeStars& stars) : mesh_(mesh), stars_(stars) {}

  /// Whether nothing is in the way of a slit, of those taken before neither.
  bool is_free(const std::vector<Index>& loop, const SlitSides& sides, const ClosedSlit& slit);
  /// To be called for a slit that is made, before it is.
  void take(const std::vector<Index>& loop, const SlitSides& sides, const ClosedSlit& slit);

 private:
  std::vector<Triangle> surface_of(const std::vector<Index>& loop, const SlitSides& sides,
                                   const ClosedSlit& slit) const;
  std::vector<Triangle> others_near(const std::vector<Index>& loop, const Box& box);
  std::vector<Index> near_vertices(const std::vector<Index>& loop) const;

  const Mesh& mesh_;
  const HalfedgeStars& stars_;
  Bvh faces_;  ///< built when the first question is asked
  std::vector<std::vector<Triangle>> taken_;
};

}  // namespace transformesh
