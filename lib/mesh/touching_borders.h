/// Border edges that lie upon each other and have opposite directions: faces that meet there in
/// space but share no vertices, as in a file of separate triangles (a soup) or along a seam. To
/// what follows indices such a mesh has holes there, and what moves vertices tears it open.
/// Positions are compared exactly. Deterministic.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

/// The number of these border edges; `borders` are the halfedges without a face across. O(b log b)
/// for b of them.
std::size_t count_touching_borders(const Mesh& mesh, const std::vector<Index>& borders);

/// The same of all border edges of the mesh. O(n), a few instructions per halfedge if there is no
/// border.
std::size_t count_touching_borders(const Mesh& mesh);

/// Throws InputError if there are such edges, for what moves vertices and may not join them.
void refuse_touching_borders(const Mesh& mesh);

}  // namespace transformesh
