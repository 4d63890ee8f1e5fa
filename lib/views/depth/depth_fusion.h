/// Opens a visual hull where depth maps see into it: signed distances to what the views see, fused
/// on the hull's grid.
/// Reference: Curless & Levoy, "A volumetric method for building complex models from range images",
/// SIGGRAPH 1996.
///
/// A node before the depth of a view is free there by that distance, one closely behind it solid,
/// and of one farther behind the view gives no evidence. The mean over the views, cut off at a few
/// cells, counts by how many they are. So a few wrong depths among many nodes open nothing, and no
/// thin sheets are left between rays. Into what no view sees the values around it diffuse (Davis,
/// Marschner, Garr & Levoy, "Filling holes in complex surfaces using volumetric diffusion", 3DPVT
/// 2002): behind surfaces it is solid, and where a surface has a gap, it goes on smoothly.
#pragma once

#include <span>

#include "support/progress.h"
#include "views/depth/depth_maps.h"

namespace transformesh {

struct DepthFusionOptions {
  double truncation = 3;  ///< cells, > 0: distances are cut off at it
  double prior = 0.5;     ///< > 0: views whose word what no view sees is worth, as being solid
  int blur = 1;           ///< cells, >= 0: radius of the neighborhood that votes
  int rounds = 200;       ///< >= 0, of diffusion: as many cells as it may reach
};

/// The larger of the hull's value and the fused one, at each node. O(nodes * views), in parallel;
/// the same for any number of threads.
ValueGrid fuse_depths(const ValueGrid& hull, std::span<const View> views,
                      std::span<const DepthMap> maps, const DepthFusionOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
