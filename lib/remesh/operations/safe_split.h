/// Splits long edges without adding self-intersections.
#pragma once

#include <functional>
#include <memory>

#include "remesh/operations/split.h"
#include "transformesh/control.h"

namespace transformesh {

struct SafeSplitOptions {
  SplitLimits limits;
  std::function<std::unique_ptr<EmbeddingGuard>()>
      make_guard;  ///< makes a guard of the current mesh
};

struct SafeSplits {
  std::unique_ptr<EmbeddingGuard> guard;  ///< guard of the mesh after the splits
  std::size_t done = 0;
  /// Number of edges that stay too long and of vertices in contact because of rounding.
  std::size_t refused = 0;
  std::vector<std::array<Index, 2>> ends = {};  ///< ends of the split edges, as in SplitCounts
};

/// Splits all long edges and then checks the result. If a new vertex has added a self-intersection
/// or a face without area, the splits are undone and slivers are removed (slivers.h). The splits
/// are then repeated with an exact test of each. If no new vertex does so, exact tests are not
/// needed.
SafeSplits split_safely(EditableMesh& mesh, const SafeSplitOptions& options,
                        const Progress& progress);

}  // namespace transformesh
