/// Cuts a face along the boundary of its exterior only (paper 3.2.2). If many faces cross a face,
/// usually only a small part of it is exterior; the remainder is not triangulated. Exact;
/// deterministic. Cost: that of bounding_subsegments.h, and of triangulating the bounding parts.
#pragma once

#include <array>
#include <optional>

#include "clean/arrange/cut_plane.h"
#include "clean/exterior/bounding_subsegments.h"
#include "clean/exterior/region_growing_winding.h"

namespace transformesh {

class ExteriorCutter {
 public:
  /// Keeps references to all arguments except the level. The exterior has winding number w <
  /// winding level in front and w >= winding level behind.
  ExteriorCutter(const WeldedMesh& welded, const Planes& planes, const WindingJumps& jumps,
                 const RegionGrowingWinding& windings, const RayCastFrontWinding& ray,
                 int winding_level)
      : welded_(welded),
        planes_(planes),
        jumps_(jumps),
        windings_(windings),
        ray_(ray),
        winding_level_(winding_level),
        geometry_(welded.points, welded.faces) {}

  /// Returns the exterior facets of a plane with a single face. Returns nothing if other faces do
  /// more than cross this face (bounding_subsegments.h). Then the plane has to be cut in full.
  std::optional<PlaneCut> cut(const Plane& plane);
  std::size_t rays() const { return rays_; }

 private:
  class FaceCut;

  const WeldedMesh& welded_;
  const Planes& planes_;
  const WindingJumps& jumps_;
  const RegionGrowingWinding& windings_;
  const RayCastFrontWinding& ray_;
  int winding_level_;
  ExactGeometry geometry_;
  std::size_t rays_ = 0;
};

}  // namespace transformesh
