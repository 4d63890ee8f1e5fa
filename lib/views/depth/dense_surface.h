/// Makes a surface from photographs without masks: computes depth maps of all views and fuses them
/// to a truncated signed distance function. The surface is open where too few views observe it.
/// Reference: Goesele, Curless & Seitz, "Multi-view stereo revisited", CVPR 2006, for surfaces from
/// depth maps that are fused by their distances.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/measure.h"
#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"
#include "views/depth/depth_maps.h"
#include "views/depth/distance_blocks.h"

namespace transformesh {

struct DenseOptions {
  /// Box in which the surface is searched; default: that of viewed_region().
  std::optional<Box> box = std::nullopt;
  /// Side of a grid cell, in input units; default: from `cell_px`.
  std::optional<double> cell = std::nullopt;
  double cell_px = 1.5;  ///< side of a grid cell, in pixels of the shrunk photographs
  double size_px = 640;  ///< photographs are shrunk so that the longer side has at most this length
  /// Components with less than this fraction of the largest component's area are dropped; [0, 1].
  double crumbs = 0.01;
  PairOptions pairs = {};
  DepthMapsOptions maps = {.sweep = {}, .least_views = 2};
  DistanceBlocksOptions fusion = {};
};

struct DenseSurface {
  /// Oriented manifold without self-intersection; open where too few views observe the surface.
  Mesh mesh;
  Box box;  ///< box in which the surface was searched
  double cell = 0;
  double scale = 1;            ///< factor by which photographs were shrunk for the depth maps
  std::size_t pixels = 0;      ///< number of pixels of all photographs at that scale
  std::size_t consistent = 0;  ///< number of pixels whose depth other views confirm
  std::vector<std::string> idle_views;  ///< names of views without a confirmed depth
  std::size_t dropped_components = 0;
};

/// Reconstructs the surface. All views must have photographs; silhouettes are ignored. Throws
/// InputError if there are fewer than two views, and GoalError if the views confirm no depths.
/// Memory and time: see sweep_planes() and fuse_distances(). Parallel; the result does not depend
/// on the number of threads.
DenseSurface dense_surface(std::span<const View> views, const DenseOptions& options = {},
                           const Progress& progress = {});

}  // namespace transformesh
