/// Variant of remesh() for callers that know the connectivity.
#pragma once

#include <vector>

#include "transformesh/remesh.h"

namespace transformesh {

/// Does the same as remesh() (remesh.h). `opposites` has the opposite of each halfedge
/// (adjacency.h), or is empty if unknown.
RemeshResult remesh_connected(Mesh& mesh, const RemeshOptions& options, const Progress& progress,
                              std::vector<Index> opposites);

}  // namespace transformesh
