/// Which halfedges of an oriented manifold lie across from each other.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

/// For each halfedge the one that has the opposite direction along its edge, or no_index on a
/// border. Throws InputError with face ids where an index is out of range, a face uses a vertex
/// twice, or two faces traverse an edge in the same direction, as if there are three. O(n).
std::vector<Index> manifold_opposites(const Mesh& mesh);

}  // namespace transformesh
