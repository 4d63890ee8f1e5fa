/// Splits long edges without adding self-intersections.
#pragma once

#include <functional>
#include <memory>

#include "remesh/operations/split.h"
#include "transformesh/control.h"

namespace transformesh {

struct SafeSplitOptions {
  SplitLimits limits;
  std::function<std::unique_ptr<EmbeddingGuard>()> make_guard;  ///< for the mesh as it is then
};

struct SafeSplits {
  std::unique_ptr<EmbeddingGuard> guard;  ///< for the mesh after the splits
  std::size_t done = 0;
  std::size_t refused = 0;  ///< edges that stay too long, or vertices that rounding left in contact
  std::vector<std::array<Index, 2>> ends = {};  ///< SplitCounts::ends
};

/// Splits first and checks the result. If a vertex has added a self-intersection or a face without
/// area, the splits are undone, slivers are removed (slivers.h), and the splits are done again,
/// each one tested exactly. Meshes without such contact do not pay for exact tests.
SafeSplits split_safely(EditableMesh& mesh, const SafeSplitOptions& options,
                        const Progress& progress);

}  // namespace transformesh
