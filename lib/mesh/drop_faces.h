/// Some faces less, with their rows of columns. Vertices stay. Cost: O(n).
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the number of marked faces, which are dropped.
std::size_t drop_faces(Mesh& mesh, const std::vector<char>& is_dropped);

}  // namespace transformesh
