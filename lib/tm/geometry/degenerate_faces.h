/// Faces without area, exactly: their corners lie on one line or in one point. Ascending.
/// Cost: O(n); parallel; deterministic.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

std::vector<Index> degenerate_faces(const Mesh& mesh);

}  // namespace transformesh
