/// Some faces of a mesh as a mesh of their own, with the vertices that they use and no columns.
/// Vertices are in the order in which the faces name them. Cost: O(n) for n vertices of the whole.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

Mesh mesh_of_faces(const Mesh& mesh, const std::vector<Index>& faces);

}  // namespace transformesh
