/// Cuts a face only along the boundary of its exterior part (paper 3.2.2). If many other faces
/// cross a face, usually only a small part of it is exterior; the remainder is not triangulated.
/// Exact; deterministic. Cost: that of bounding_subsegments.h, and of triangulating the parts of
/// segments that it finds.
#pragma once

#include <array>
#include <optional>

#include "clean/arrange/cut_plane.h"
#include "clean/exterior/bounding_subsegments.h"
#include "clean/exterior/region_growing_winding.h"

namespace transformesh {

class ExteriorCutter {
 public:
  /// Keeps references to all arguments except `winding_level`. A point of a face is exterior if the
  /// winding number is w < winding level in front of the face and w >= winding level behind it.
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

  /// Returns the exterior triangles of a plane with a single face. Returns nothing if this is not
  /// possible, for example if another face touches this face instead of crossing it. Then the
  /// caller has to cut the face along all intersections.
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
