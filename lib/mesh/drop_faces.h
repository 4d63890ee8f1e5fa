/// Removes faces, with their rows of columns. Vertices stay. Cost: O(n).
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Drops the marked faces and returns their number.
std::size_t drop_faces(Mesh& mesh, const std::vector<char>& is_dropped);

}  // namespace transformesh
