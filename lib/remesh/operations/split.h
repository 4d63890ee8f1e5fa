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
  std::vector<Index> parents;              ///< per appended face, the face that it is a half of
  std::vector<std::array<Index, 2>> ends;  ///< per appended vertex, those of the edge split
};

struct SplitLimits {
  double longest = 0;        ///< longer edges are split
  bool keep_border = false;  ///< border edges are not
  bool only_given = false;   ///< nor are edges that come of splits
};

/// Splits edges longer than the limit until none is left, the longest first (ties: the lowest
/// halfedge). The surface moves only by rounding, which is not checked; nothing is refused.
SplitCounts split_long_edges(EditableMesh& mesh, const SplitLimits& limits,
                             const Progress& progress);

/// The same without self-intersections and faces without area (exact_split.h). An edge that cannot
/// be split is refused and kept, and so are shorter edges of its faces. `ends` stays empty.
SplitCounts split_long_edges_exactly(EditableMesh& mesh, const SplitLimits& limits,
                                     const Progress& progress);

/// Rounding moves a midpoint off its edge, perhaps through another sheet that is as near as that.
/// Moves those of the vertices from `first` on that are in contact by a few roundings, to either
/// side of the surface. Returns those that stay in contact, as where the input intersects itself.
std::vector<Index> settle_midpoints(EditableMesh& mesh, EmbeddingGuard& guard, Index first);

}  // namespace transformesh
