/// Estimates the depth map of a photograph from its neighbors, by plane sweeping.
/// Reference: Collins, "A space-sweep approach to true multi-image matching", CVPR 1996.
///
/// The planes are perpendicular to the viewing axis, equidistant in inverse depth, and intersect
/// the visual hull. On each plane the photograph is compared with its neighbors in windows
/// (correlation.h). Only points in the hull count. The cost of a plane is 1 minus the mean
/// correlation of the two neighbors that agree best; other neighbors may be occluded.
///
/// Costs are summed along paths (semiglobal_matching.h). The depth of a pixel is the one with the
/// least sum, interpolated between planes by a parabola. If the correlation is low at this depth,
/// the depth is unknown. Other depths may still be wrong: see depth_maps.h.
#pragma once

#include <span>

#include "views/cameras/view.h"
#include "views/depth/semiglobal_matching.h"
#include "views/hull/marching_tetrahedra.h"
#include "views/photo/correlation.h"

namespace transformesh {

struct PlaneSweepOptions {
  CorrelationOptions correlation = {.noise_variance = 4, .contrast = 0};
  double step = 2;  ///< distance of consecutive planes in the image, at most; pixels, > 0
  SemiglobalOptions semiglobal;
  double least_correlation = 0.3;  ///< least mean correlation of the two best neighbors; [0, 1]
};

struct DepthMap {
  GrayImage depth;       ///< size of the view; depth as in PinholeCamera; 0 if unknown
  double plane_gap = 0;  ///< distance between planes, in inverse depth
};

/// Returns the depth map of `view`. `hull` is negative inside. All depths are unknown if there are
/// no neighbors. O(pixels * planes * neighbors); 8 bytes per plane and pixel of the hull's
/// rectangle. Deterministic.
DepthMap sweep_planes(const View& view, std::span<const View* const> neighbors,
                      const ValueGrid& hull, const PlaneSweepOptions& options = {});

}  // namespace transformesh
