/// Splits long edges at their midpoints.
#pragma once

#include <array>
#include <vector>

#include "remesh/guards/embedding_guard.h"
#include "transformesh/control.h"

namespace transformesh {

struct SplitCounts {
  std::size_t done = 0;
  std::size_t refused = 0;
  std::vector<Index> parents;  ///< for each new face the face of which it is a half
  /// For each new vertex the ends of the edge that was split.
  std::vector<std::array<Index, 2>> ends;
};

struct SplitLimits {
  double longest = 0;        ///< edges longer than this are split
  bool keep_border = false;  ///< do not split border edges
  bool only_given = false;   ///< do not split edges that splits have made
};

/// Splits edges longer than the limit until none is left, the longest edge first; ties are broken
/// by the lowest halfedge. The surface moves only by rounding, which is not checked for
/// intersections. No split is refused.
SplitCounts split_long_edges(EditableMesh& mesh, const SplitLimits& limits,
                             const Progress& progress);

/// Does the same as split_long_edges(), with exact tests that no split adds self-intersections or
/// faces without area (exact_split.h). An edge that cannot be split stays, and so do shorter edges
/// of its faces. `ends` stays empty.
SplitCounts split_long_edges_exactly(EditableMesh& mesh, const SplitLimits& limits,
                                     const Progress& progress);

/// Moves midpoints that are in contact with other faces. Rounding may have moved them off their
/// edge and through a very close sheet. Tries movements of a few spacings to either side of the
/// surface, for vertices from `first` on. Returns vertices that stay in contact, for example if the
/// input intersects itself.
std::vector<Index> settle_midpoints(EditableMesh& mesh, EmbeddingGuard& guard, Index first);

}  // namespace transformesh
