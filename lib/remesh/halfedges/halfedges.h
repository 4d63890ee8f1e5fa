/// Finds opposite halfedges of an oriented manifold.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns for each halfedge its opposite, or no_index on a border. Throws InputError with face
/// indices if an index is out of range, a face uses a vertex twice, or two faces traverse an edge
/// in the same direction. Two of three faces at an edge always traverse it in the same direction.
/// O(n).
std::vector<Index> manifold_opposites(const Mesh& mesh);

}  // namespace transformesh
