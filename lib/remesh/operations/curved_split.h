/// Splits long edges and puts the new vertices onto the smooth surface that the mesh samples.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/operations/safe_split.h"
#include "transformesh/remesh_options.h"

namespace transformesh {

/// Splits edges like split_safely(), and moves each new vertex to curved_midpoint() of the edge
/// that it halves. The vertex moves half of the way or not at all if the guard or the shape of the
/// triangles requires that. Edges that splits have made are split in further rounds, after these
/// moves and after flips by `rule` within `limits`. The flips divide a face of three long edges in
/// four, so that no median is split. No other vertex moves. Adds the number of flips to `flips`.
SafeSplits split_onto_curves(EditableMesh& mesh, SafeSplitOptions options, FlipRule rule,
                             const EdgeLimits& limits, std::size_t& flips,
                             const Progress& progress);

}  // namespace transformesh
