/// Splits long edges at their midpoints.
#pragma once

#include "tm/remesh/guards/embedding_guard.h"
#include "tm/support/progress.h"

namespace transformesh {

/// Splits edges longer than `max_edge` until none is left, the longest first (ties: the lowest
/// halfedge). The surface does not move but by rounding. Returns the number of splits.
std::size_t split_long_edges(EditableMesh& mesh, double max_edge, bool keep_border,
                             const Progress& progress);

/// Rounding moves a midpoint off its edge, perhaps through another sheet that is as near as that.
/// Moves those of the vertices from `first` on that are in contact by a few roundings, to either
/// side of the surface. Returns how many stay in contact, as where the input crosses itself.
std::size_t settle_midpoints(EditableMesh& mesh, EmbeddingGuard& guard, Index first);

}  // namespace transformesh
