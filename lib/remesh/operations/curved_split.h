/// Splits long edges and puts the new vertices onto the smooth surface that the mesh samples.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/operations/safe_split.h"
#include "transformesh/remesh_options.h"

namespace transformesh {

/// Splits edges like split_safely(), and moves each new vertex to curved_midpoint() of the edge
/// that it halves. If the guard or the shape of the triangles forbids the movement, the vertex
/// moves half of the way or not at all. Edges that splits have made are split in further rounds.
/// Before each round, vertices move, and edges are flipped by `rule` within `limits`. The flips
/// usually turn a face whose three edges were split into four similar triangles. Without them, the
/// next round would split medians of the face. No other vertex moves.
/// Adds the number of flips to `flips`.
SafeSplits split_onto_curves(EditableMesh& mesh, SafeSplitOptions options, FlipRule rule,
                             const EdgeLimits& limits, std::size_t& flips,
                             const Progress& progress);

}  // namespace transformesh
