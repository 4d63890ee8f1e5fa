/// Opens deep hollows of an object that its visual hull fills. Silhouettes do not show such
/// hollows, but depth maps do. Evolving the hull towards the photographs (photo_step.h) would not
/// reach the bottom of these hollows.
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
  /// Length of the longest side of the object in the shrunk photographs, in pixels. A first search
  /// for hollows uses `trial_px`. If there are hollows, a second one uses `size_px`. Larger sizes
  /// find smaller hollows but take longer.
  double trial_px = 140, size_px = 250;
  double cell_px = 1.5;  ///< size of a grid cell, in pixels of the shrunk photographs
  /// Least fraction of the hull's volume that depth maps must show to be free, more than four cells
  /// below its surface; [0, 1].
  double least_share = 0.005;
  /// Largest accepted decrease of the mean intersection over union of silhouettes that opening the
  /// hull causes; in [0, 1]. A larger decrease indicates wrong depth maps, for example if
  /// photographs do not belong to the cameras.
  double most_agreement_lost = 0.05;
  /// Components with less than this fraction of the largest volume are dropped; [0, 1]. Default:
  /// components are chosen by the silhouettes.
  std::optional<double> keep = std::nullopt;
  PairOptions pairs;
  /// Options of the depth maps. The noise variance refers to full size; it is divided by the
  /// squared scale.
  DepthMapsOptions maps;
  DepthFusionOptions fusion;
};

struct OpenedHull {
  Mesh mesh;  ///< closed, oriented 2-manifold without self-intersection, like HullResult::mesh
  double scale = 1;  ///< factor by which photographs were shrunk for the depth maps
};

/// Returns the opened hull. Returns nothing if no hollow is deep enough, or if silhouettes would
/// change too much. Every view must have a photograph and a silhouette. Throws as visual_hull()
/// does. O(pixels at `size_px` * planes * pairs). Parallel; the result does not depend on the
/// number of threads.
std::optional<OpenedHull> opened_hull(std::span<const View> views,
                                      const OpenedHullOptions& options = {},
                                      const Progress& progress = {});

}  // namespace transformesh
