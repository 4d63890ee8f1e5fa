/// Makes a surface from photographs without masks: depth maps of all views, fused to a truncated
/// signed distance function. The surface is open where too few views observe it.
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
  std::optional<Box> box = std::nullopt;      ///< searched box; default: viewed_region()
  std::optional<double> cell = std::nullopt;  ///< size of a cell; default: `cell_px` pixels
  double cell_px = 1.5;  ///< size of a cell, in pixels of the shrunk photographs
  double size_px = 640;  ///< photographs are shrunk to at most this length of the longer side
  double crumbs = 0.01;  ///< drop components of less than this share of the largest area; [0, 1]
  PairOptions pairs = {};
  DepthMapsOptions maps = {.sweep = {}, .least_views = 2};
  DistanceBlocksOptions fusion = {};
};

struct DenseSurface {
  Mesh mesh;  ///< oriented manifold without self-intersection, open where nothing was observed
  Box box;    ///< searched box
  double cell = 0;
  double scale = 1;                     ///< scale of the photographs whose depths were fused
  std::size_t pixels = 0;               ///< pixels of the photographs at that scale
  std::size_t consistent = 0;           ///< pixels whose depth other views confirm
  std::vector<std::string> idle_views;  ///< views without such a pixel
  std::size_t dropped_components = 0;
};

/// Views need photographs; silhouettes are ignored. Throws InputError if there are fewer than two
/// views, and GoalError if the views confirm no depths. Memory and time: see sweep_planes() and
/// fuse_distances(). Parallel; the result does not depend on the number of threads.
DenseSurface dense_surface(std::span<const View> views, const DenseOptions& options = {},
                           const Progress& progress = {});

}  // namespace transformesh
