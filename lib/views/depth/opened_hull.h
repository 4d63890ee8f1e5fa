/// The visual hull, opened where photographs see into hollows that no silhouette shows: as deep as
/// that steps from a hull (photo_step.h) would not get there.
#pragma once

#include <optional>
#include <span>

#include "transformesh/control.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"
#include "views/depth/depth_fusion.h"
#include "views/hull/hull_values.h"

namespace transformesh {

struct OpenedHullOptions {
  /// Photographs are made smaller, so that the longest side is as long: at first, and where that
  /// shows hollows.
  double trial_px = 140, size_px = 250;
  double cell_px = 1.5;  ///< of the grid, in pixels of these
  /// [0, 1]: of the hull's volume, that must be open deeper than four cells.
  double least_share = 0.005;
  /// [0, 1]: in silhouette_agreement, on average. Depths of photographs that do not belong to the
  /// cameras take more than hollows away.
  double most_agreement_lost = 0.05;
  double keep = 1;  ///< HullOptions::keep
  PairOptions pairs;
  DepthMapsOptions maps;  ///< the variance of the noise at full size, which shrinks with them
  DepthFusionOptions fusion;
};

struct OpenedHull {
  Mesh mesh;         ///< as HullResult::mesh
  double scale = 1;  ///< of the photographs whose depths were fused
};

/// Nothing where no hollow is that deep, or silhouettes are lost. Every view has
/// a photograph and a silhouette; throws as visual_hull() does. O(pixels at that size * planes *
/// pairs); in parallel, the same for any number of threads.
std::optional<OpenedHull> opened_hull(std::span<const View> views,
                                      const OpenedHullOptions& options = {},
                                      const Progress& progress = {});

}  // namespace transformesh
