/// Splits long edges and puts the new vertices onto the smooth surface that the mesh samples.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/operations/safe_split.h"
#include "transformesh/remesh_options.h"

namespace transformesh {

/// Does what split_safely() does, and moves each new vertex to curved_midpoint() of the edge that it
/// halves, or half the way, or not at all, as the guard and the shape of the triangles allow. Edges
/// that come of splits are split in further rounds, after these moves and after flips by `rule`
/// within `limits`: a face of three long edges is then divided in four, and no median is split.
/// No other vertex moves. Adds the flips to `flips`.
SafeSplits split_onto_curves(EditableMesh& mesh, SafeSplitOptions options, FlipRule rule,
                             const EdgeLimits& limits, std::size_t& flips,
                             const Progress& progress);

}  // namespace transformesh
