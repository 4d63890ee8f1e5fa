/// Splits long edges at their midpoints.
#pragma once

#include "remesh/guards/embedding_guard.h"
#include "transformesh/control.h"

namespace transformesh {

struct SplitCounts {
  std::size_t done = 0;
  std::size_t refused = 0;
  std::vector<Index> parents;  ///< per appended face, the face that it is a half of
};

/// Splits edges longer than `max_edge` until none is left, the longest first (ties: the lowest
/// halfedge). The surface moves only by rounding, which is not checked; nothing is refused.
SplitCounts split_long_edges(EditableMesh& mesh, double max_edge, bool keep_border,
                             const Progress& progress);

/// The same without self-intersections and faces without area (exact_split.h). An edge that cannot
/// be split is refused and kept, and so are shorter edges of its faces.
SplitCounts split_long_edges_exactly(EditableMesh& mesh, double max_edge, bool keep_border,
                                     const Progress& progress);

/// Rounding moves a midpoint off its edge, perhaps through another sheet that is as near as that.
/// Moves those of the vertices from `first` on that are in contact by a few roundings, to either
/// side of the surface. Returns those that stay in contact, as where the input intersects itself.
std::vector<Index> settle_midpoints(EditableMesh& mesh, EmbeddingGuard& guard, Index first);

}  // namespace transformesh
