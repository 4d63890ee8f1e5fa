/// Extracts faces of a mesh as a new mesh, with the vertices that they use and without columns. The
/// vertices of the new mesh are in order of their first use. Cost: O(n) for n vertices of the whole
/// mesh.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

Mesh mesh_of_faces(const Mesh& mesh, const std::vector<Index>& faces);

}  // namespace transformesh
