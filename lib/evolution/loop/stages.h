/// Stages of an iteration (iteration.h), such as cleaning and remeshing, that loops also call
/// separately.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/iteration.h"

namespace transformesh {

/// Returns the options with a reference edge. If it is 0, it is replaced by the mean edge length of
/// the mesh.
IterationOptions completed(IterationOptions options, const Mesh& mesh);

/// Runs remesh() without pinching, and then rounds all numbers to the types in which the document
/// will be written. `opposites` are the opposite halfedges, or empty if unknown.
RemeshResult remesh_in_place(Document& document, const IterationOptions& options,
                             const Progress& progress = Progress(),
                             std::vector<Index> opposites = {});

/// Splits edges longer than `max_edge`, and changes nothing else. A motion would move the long
/// faces of a coarse mesh as a whole.
void split_long_edges(Document& document, const IterationOptions& options,
                      const Progress& progress = Progress());

struct CleanedTopology {
  Topology topology;
  bool changed = false;
  std::size_t pairs = 0;
  /// Opposite halfedges for remesh_in_place(); empty if they were not computed.
  std::vector<Index> opposites;
};

/// Runs clean(), and then rounds all numbers to the types in which the document will be written.
/// See IterationOptions for `on_cleaned`.
CleanedTopology clean_in_place(
    Document& document, const Progress& progress = Progress(), bool outermost = true,
    const std::function<void(const Mesh& before, Mesh& cleaned)>& on_cleaned = {});

}  // namespace transformesh
