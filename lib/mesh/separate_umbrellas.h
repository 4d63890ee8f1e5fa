/// Duplicates vertices at which several umbrellas (umbrellas.h) meet, so that the mesh becomes a
/// manifold there (paper 3.3.1). Cost: O(n); deterministic.
#pragma once

#include <vector>

#include "mesh/umbrellas.h"

namespace transformesh {

/// Gives each umbrella its own vertex. Removes vertices that no face uses, except those whose flag
/// in `stays` is set; `stays` may be empty. The first umbrella of each vertex in
/// `umbrellas.vertex_of` keeps the vertex. The others get duplicates, which follow all vertices.
/// Returns the number of duplicates.
std::size_t separate_umbrellas(Mesh& mesh, const Umbrellas& umbrellas,
                               const std::vector<char>& stays = {});

}  // namespace transformesh
