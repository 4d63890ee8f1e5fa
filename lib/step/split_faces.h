/// Splits faces without moving the surface.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Splits edges at their midpoints, in all faces at once, until none is longer than `longest`
/// (above 0, input units). New vertices follow those that were there; faces are replaced in place.
/// Columns are dropped. Vertices are the same when their indices are. Returns whether there was
/// anything to split. Cost: O(n) for the faces of the result. Deterministic.
bool split_faces(Mesh& mesh, double longest);

}  // namespace transformesh
