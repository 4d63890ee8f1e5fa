/// Numbers of faces at vertices.
#pragma once

#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Vertices with more faces than this have high valence. Operations treat them in other ways, if
/// tests of all their faces would take too long. Chosen by hand, not measured: a lower limit
/// changes results for more meshes; a higher limit makes meshes with such vertices slower.
inline constexpr Index usual_valence = 256;

/// Returns the number of faces at each vertex. O(n).
std::vector<Index> valences_of(const EditableMesh& mesh);
/// True if a vertex has more than `usual_valence` faces. O(n).
bool has_high_valence(const EditableMesh& mesh);

}  // namespace transformesh
