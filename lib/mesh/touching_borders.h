/// Border edges that coincide and have opposite directions. Their faces meet in space but share no
/// vertices, as in a file of separate triangles (a soup) or along a seam. At such edges, algorithms
/// that rely on indices find holes, and algorithms that move vertices open gaps. Positions are
/// compared exactly. Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the number of coincident border edges with opposite directions. `borders` are the
/// halfedges without an opposite face. O(b log b) for b halfedges.
std::size_t count_touching_borders(const Mesh& mesh, const std::vector<Index>& borders);

/// Returns the number of coincident border edges with opposite directions in the mesh. O(n); a few
/// instructions per halfedge if there is no border.
std::size_t count_touching_borders(const Mesh& mesh);

/// Throws InputError if the mesh has coincident border edges with opposite directions. For
/// operations that move vertices without joining them.
void refuse_touching_borders(const Mesh& mesh);

}  // namespace transformesh
