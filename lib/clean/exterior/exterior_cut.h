/// Cuts faces along what bounds their exterior, and along nothing else (paper 3.2.2): of a face
/// that many others cross, usually little is exterior, and all else need not be triangulated.
/// Exact; deterministic.
#pragma once

#include <array>
#include <optional>

#include "clean/arrange/cut_plane.h"
#include "clean/exterior/bounding_subsegments.h"
#include "clean/exterior/region_growing_winding.h"

namespace transformesh {

class ExteriorCutter {
 public:
  /// Keeps references. What is exterior has w < winding level in front and w >= winding level
  /// behind it.
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

  /// The exterior facets of the only face of a plane. Nothing where other faces do not merely cross
  /// it (bounding_subsegments.h): the plane has to be cut in full.
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
