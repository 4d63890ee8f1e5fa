/// Splits long edges at their midpoints.
#pragma once

#include "tm/remesh/editable_mesh.h"
#include "tm/support/progress.h"

namespace transformesh {

/// Splits edges longer than `max_edge` until none is left, the longest first (ties: the lowest
/// halfedge). The surface does not move but by rounding. Returns the number of splits.
std::size_t split_long_edges(EditableMesh& mesh, double max_edge, bool keep_border,
                             const Progress& progress);

}  // namespace transformesh
