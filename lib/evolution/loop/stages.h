/// The stages of an iteration (iteration.h) that loops also run alone.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/iteration.h"

namespace transformesh {

/// Returns the options with the reference edge of the mesh if they have none.
IterationOptions completed(IterationOptions options, const Mesh& mesh);

/// Runs remesh() without pinching and rounds as written. `opposites` are those of the halfedges, or
/// empty.
RemeshResult remesh_in_place(Document& document, const IterationOptions& options,
                             const Progress& progress = Progress(),
                             std::vector<Index> opposites = {});

struct CleanedTopology {
  Topology topology;
  bool changed = false;
  std::size_t pairs = 0;
  std::vector<Index> opposites;  ///< opposite halfedges if they were found, for remesh_in_place()
};

/// Runs clean() and rounds as written. `on_cleaned` is that of IterationOptions.
CleanedTopology clean_in_place(
    Document& document, const Progress& progress = Progress(), bool outermost = true,
    const std::function<void(const Mesh& before, Mesh& cleaned)>& on_cleaned = {});

}  // namespace transformesh
