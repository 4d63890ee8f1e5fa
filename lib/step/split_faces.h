/// Splits long edges without moving the surface.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Splits edges at their midpoints, together with all their faces, until no edge is longer than
/// `longest`, which must be > 0; input units. New vertices are appended. The parts of a face take
/// its place in the order of faces. Columns are dropped. Equal positions with different indices are
/// different vertices. Returns true if an edge was split. Cost: O(n) for n faces of the result.
/// Deterministic.
bool split_faces(Mesh& mesh, double longest);

}  // namespace transformesh
