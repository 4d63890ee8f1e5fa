/// The depths at which a photograph agrees with its neighbors, by plane sweeping.
/// Reference: Collins, "A space-sweep approach to true multi-image matching", CVPR 1996.
///
/// Planes across the viewing axis, evenly spaced by inverse depth, cut the visual hull. On each of
/// them the photograph is compared with its neighbors in windows (correlation.h), of which only
/// what is in the hull counts; of the neighbors the two that agree best, as others may not see the
/// place. The cost of a plane is 1 less their mean correlation; costs are added up along paths
/// (semiglobal_matching.h), and the depth of a pixel is where the sum is least, between planes by a
/// parabola. Where they do not agree there it is not known; else it may still be wrong: see
/// depth_maps.h.
#pragma once

#include <span>

#include "views/cameras/view.h"
#include "views/depth/semiglobal_matching.h"
#include "views/hull/marching_tetrahedra.h"
#include "views/photo/correlation.h"

namespace transformesh {

struct PlaneSweepOptions {
  CorrelationOptions correlation = {.noise_variance = 4, .contrast = 0};
  double step = 2;  ///< pixels from plane to plane, where that is most; > 0
  SemiglobalOptions semiglobal;
  double least_correlation = 0.3;  ///< [0, 1], mean of two neighbors at the depth found
};

struct DepthMap {
  GrayImage depth;       ///< of the view's size, as the camera defines it; 0 where it is not known
  double plane_gap = 0;  ///< between planes, in inverse depth
};

/// `hull` is negative inside. Without neighbors nothing is known. O(pixels * planes * neighbors);
/// 8 bytes for each plane of each pixel of the hull's rectangle. Deterministic.
DepthMap sweep_planes(const View& view, std::span<const View* const> neighbors,
                      const ValueGrid& hull, const PlaneSweepOptions& options = {});

}  // namespace transformesh
