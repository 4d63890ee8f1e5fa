/// Opens a visual hull where depth maps show hollows: fuses signed distances to visible surfaces on
/// the grid of the hull.
/// Reference: Curless & Levoy, "A volumetric method for building complex models from range images",
/// SIGGRAPH 1996.
///
/// A node in front of the depth of a view has a positive distance (free). A node closely behind
/// that depth has a negative distance (solid). If a node is farther behind, the view gives no
/// evidence. Distances are truncated at a few cells and averaged over views and neighboring nodes.
/// The number of views is their weight against the prior. Hence a few wrong depths among many nodes
/// open nothing, and no thin sheets remain between rays.
///
/// Unobserved nodes get values by diffusion from the nodes around them (Davis, Marschner, Garr &
/// Levoy, "Filling holes in complex surfaces using volumetric diffusion", 3DPVT 2002). Space behind
/// surfaces thus becomes solid, and gaps in a surface are filled smoothly.
#pragma once

#include <span>

#include "transformesh/control.h"
#include "views/cameras/view.h"
#include "views/depth/depth_maps.h"

namespace transformesh {

struct DepthFusionOptions {
  double truncation = 3;  ///< distances are truncated at this value; cells, > 0
  double prior = 0.5;  ///< weight of the assumption that unobserved space is solid, in views; > 0
  int blur = 1;      ///< radius of the neighborhood over which distances are averaged; cells, >= 0
  int rounds = 200;  ///< rounds of diffusion, >= 0; each reaches one cell farther
};

/// Returns at each node the maximum of the hull's value and the fused value. O(nodes * views),
/// parallel; the result does not depend on the number of threads.
ValueGrid fuse_depths(const ValueGrid& hull, std::span<const View> views,
                      std::span<const DepthMap> maps, const DepthFusionOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
