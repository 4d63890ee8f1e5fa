/// The depths at which a photograph agrees with its neighbors, by plane sweeping.
/// Reference: Collins, "A space-sweep approach to true multi-image matching", CVPR 1996.
///
/// Planes across the viewing axis, evenly spaced by inverse depth, cut the visual hull. On each of
/// them the photograph is compared with its neighbors in windows (correlation.h), of which only
/// what is in the hull counts; of the neighbors the two that agree best, as others may not see the
/// place. The depth of a pixel is where they agree best, between planes by a parabola. It is kept
/// where they agree well there and clearly less at any other depth (the peak's lead: Hu & Mordohai,
/// "A quantitative evaluation of confidence measures for stereo vision", PAMI 34(11), 2012).
#pragma once

#include <span>

#include "tm/views/cameras/view.h"
#include "tm/views/hull/marching_tetrahedra.h"
#include "tm/views/photo/correlation.h"

namespace transformesh {

struct PlaneSweepOptions {
  CorrelationOptions correlation = {.noise_variance = 4, .contrast = 0};
  double step = 2;                 ///< pixels from plane to plane, where that is most; > 0
  double least_correlation = 0.5;  ///< [0, 1], mean of two neighbors
  double least_lead = 0.02;        ///< >= 0: how much less it is at all other depths
};

struct DepthMap {
  GrayImage depth;       ///< of the view's size, as the camera defines it; 0 where it is not known
  double plane_gap = 0;  ///< between planes, in inverse depth
};

/// `hull` is negative inside. Without neighbors nothing is known. O(pixels * planes * neighbors);
/// 4 bytes for each plane of each pixel of the hull's rectangle. Deterministic.
DepthMap sweep_planes(const View& view, std::span<const View* const> neighbors,
                      const ValueGrid& hull, const PlaneSweepOptions& options = {});

}  // namespace transformesh
