/// Depths of all views that agree with each other: first those of each view (plane_sweep.h), of
/// which only those stay that the neighbors found as well, where they look at the same place, and
/// of these only patches, as what agrees by chance is scattered.
/// Reference: the consistency check of Merrell et al., "Real-time visibility-based fusion of depth
/// maps", ICCV 2007; patches as the speckle filter of Hirschmueller, "Stereo processing by
/// semiglobal matching and mutual information", PAMI 30(2), 2008.
#pragma once

#include <span>
#include <vector>

#include "transformesh/control.h"
#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"
#include "views/depth/plane_sweep.h"

namespace transformesh {

struct DepthMapsOptions {
  PlaneSweepOptions sweep;
  double tolerance = 1;           ///< planes by which views may differ; > 0
  std::size_t least_views = 1;    ///< neighbors that must agree
  std::size_t least_pixels = 20;  ///< of a patch whose pixels differ by less than the tolerance
};

/// One map per view. `pairs` as choose_pairs has them; `hull` is negative inside. In parallel over
/// views; the same for any number of threads.
std::vector<DepthMap> depth_maps(std::span<const View> views, std::span<const ViewPair> pairs,
                                 const ValueGrid& hull, const DepthMapsOptions& options = {},
                                 const Progress& progress = {});

}  // namespace transformesh
