/// Estimates the depth map of a photograph from its neighbors, by plane sweeping.
/// Reference: Collins, "A space-sweep approach to true multi-image matching", CVPR 1996.
///
/// The planes are perpendicular to the viewing axis, equidistant in inverse depth, and intersect
/// the visual hull. On each plane, windows of the photograph are compared with its neighboring
/// photographs (correlation.h). Only points in the hull count. The cost of a plane at a pixel is 1
/// minus the mean correlation of the two neighbors that agree best. In other neighbors, the point
/// may be occluded.
///
/// Costs are summed along paths (semiglobal_matching.h). The depth of a pixel is that of the plane
/// with the least sum, interpolated between planes by a parabola. If the correlation is low at this
/// depth, the depth is unknown. Some of the known depths are still wrong; depth_maps.h removes most
/// of them.
#pragma once

#include <span>

#include "views/cameras/view.h"
#include "views/depth/semiglobal_matching.h"
#include "views/hull/marching_tetrahedra.h"
#include "views/photo/correlation.h"

namespace transformesh {

struct PlaneSweepOptions {
  CorrelationOptions correlation = {.noise_variance = 4, .contrast = 0};
  /// Largest movement of a point in a neighboring image between consecutive planes; pixels, > 0.
  double step = 2;
  SemiglobalOptions semiglobal;
  double least_correlation = 0.3;  ///< least mean correlation of the two best neighbors; [0, 1]
};

struct DepthMap {
  GrayImage depth;  ///< depth of each pixel of the view, as defined by PinholeCamera; 0 if unknown
  double plane_gap = 0;  ///< difference of inverse depths of consecutive planes
};

/// Returns the depth map of `view`. `hull` is negative inside. All depths are unknown if there are
/// no neighbors. O(pixels * planes * neighbors); 8 bytes per plane and pixel of the hull's
/// rectangle. Deterministic.
DepthMap sweep_planes(const View& view, std::span<const View* const> neighbors,
                      const ValueGrid& hull, const PlaneSweepOptions& options = {});

}  // namespace transformesh
