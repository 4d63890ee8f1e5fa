/// Opens hollows of an object that its visual hull fills, if depth maps show these hollows. Signed
/// distances from the surfaces in the depth maps are fused on the grid of the hull. Reference:
/// Curless & Levoy, "A volumetric method for building complex models from range images", SIGGRAPH
/// 1996.
///
/// For each view, a grid node in front of the surface in its depth map has a positive distance
/// (free). A node closely behind the surface has a negative distance (solid). Nodes farther behind
/// get no distance from the view. Distances are truncated at a few cells and averaged over views
/// and neighboring nodes. The average is biased towards solid: as if `prior` further views observed
/// every node behind their surfaces. Hence a few wrong depths among many nodes open nothing, and no
/// thin sheets remain between viewing rays.
///
/// Nodes that too few views observe get values by diffusion from the nodes around them (Davis,
/// Marschner, Garr & Levoy, "Filling holes in complex surfaces using volumetric diffusion", 3DPVT
/// 2002). Space behind surfaces thus becomes solid, and gaps in a surface are filled smoothly.
#pragma once

#include <span>

#include "transformesh/control.h"
#include "views/cameras/view.h"
#include "views/depth/depth_maps.h"

namespace transformesh {

struct DepthFusionOptions {
  double truncation = 3;  ///< distances are truncated at this value; cells, > 0
  /// Weight of the assumption that all space in the hull is solid, as a number of views; > 0.
  double prior = 0.5;
  int blur = 1;      ///< radius of the neighborhood over which distances are averaged; cells, >= 0
  int rounds = 200;  ///< number of rounds of diffusion, >= 0; each reaches one cell farther
};

/// Returns at each node the maximum of the hull's value and the fused signed distance. `hull` is
/// negative inside. `maps[i]` is the depth map of `views[i]`. O(nodes * views), parallel; the
/// result does not depend on the number of threads.
ValueGrid fuse_depths(const ValueGrid& hull, std::span<const View> views,
                      std::span<const DepthMap> maps, const DepthFusionOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
