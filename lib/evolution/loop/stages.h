/// The stages of an iteration (iteration.h) that loops also call separately.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/iteration.h"

namespace transformesh {

/// Returns the options. A reference edge of 0 is replaced by the reference edge of the mesh.
IterationOptions completed(IterationOptions options, const Mesh& mesh);

/// Runs remesh() without pinching, and then rounds all numbers to the types in which the document
/// will be written. `opposites` are the opposite halfedges, or empty if unknown.
RemeshResult remesh_in_place(Document& document, const IterationOptions& options,
                             const Progress& progress = Progress(),
                             std::vector<Index> opposites = {});

struct CleanedTopology {
  Topology topology;
  bool changed = false;
  std::size_t pairs = 0;
  std::vector<Index> opposites;  ///< opposite halfedges if they were found, for remesh_in_place()
};

/// Runs clean(), and then rounds all numbers to the types in which the document will be written.
/// See IterationOptions for `on_cleaned`.
CleanedTopology clean_in_place(
    Document& document, const Progress& progress = Progress(), bool outermost = true,
    const std::function<void(const Mesh& before, Mesh& cleaned)>& on_cleaned = {});

}  // namespace transformesh
