/// Computes depth maps of all views and keeps depths that are consistent. plane_sweep.h estimates
/// the depths of each view. A depth stays if neighboring views have the same depth at that point.
/// Then small patches of pixels are removed, because depths that agree by chance are scattered.
/// Reference for the consistency check: Merrell et al., "Real-time visibility-based fusion of depth
/// maps", ICCV 2007. Reference for the removal of patches, known as speckle filter: Hirschmueller,
/// "Stereo processing by semiglobal matching and mutual information", PAMI 30(2), 2008.
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
  /// Largest difference of depths that count as equal, in distances between planes of the plane
  /// sweep; > 0.
  double tolerance = 1;
  std::size_t least_views = 1;  ///< least number of neighboring views that must have the same depth
  std::size_t least_pixels = 20;  ///< smallest number of pixels of a patch that is kept
};

/// Returns the views without silhouettes, shrunk as by at_scale(). Parallel over views.
std::vector<View> shrunk_photographs(std::span<const View> views, double scale);

/// Returns the depth map of each view. `pairs` are from choose_pairs(). `hull`, in which the
/// surface is searched, is negative inside. Parallel over views; the result does not depend on the
/// number of threads.
std::vector<DepthMap> depth_maps(std::span<const View> views, std::span<const ViewPair> pairs,
                                 const ValueGrid& hull, const DepthMapsOptions& options = {},
                                 const Progress& progress = {});

}  // namespace transformesh
