/// Splits long edges and puts the new vertices onto the smooth surface that the mesh samples.
#pragma once

#include "remesh/operations/safe_split.h"

namespace transformesh {

/// Does what split_safely() does, and moves each new vertex to curved_midpoint() of the edge that it
/// halves, or half the way, or not at all, as the guard and the shape of the triangles allow. Edges
/// that come of splits are split in further rounds, after these moves. No other vertex moves.
SafeSplits split_onto_curves(EditableMesh& mesh, SafeSplitOptions options,
                             const Progress& progress);

}  // namespace transformesh
