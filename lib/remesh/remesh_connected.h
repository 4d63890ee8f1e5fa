/// Remeshes a mesh whose connectivity the caller knows already.
#pragma once

#include <vector>

#include "transformesh/remesh.h"

namespace transformesh {

/// Does what remesh.h says. `opposites` holds the opposite of each halfedge (adjacency.h), or is
/// empty if they are not known.
RemeshResult remesh_connected(Mesh& mesh, const RemeshOptions& options, const Progress& progress,
                              std::vector<Index> opposites);

}  // namespace transformesh
