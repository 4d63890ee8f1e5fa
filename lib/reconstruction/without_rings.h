/// Cuts a part and its surroundings out of a surface.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the mesh without the faces at marked vertices. `rings` rings of neighbors are marked
/// first. O(n rings).
Mesh without_rings(const Mesh& mesh, std::vector<bool> is_marked, int rings);

}  // namespace transformesh
