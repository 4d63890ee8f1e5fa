/// Turns faces so that neighbours across two-face edges run opposite ways.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// Corners are points; `mesh` supplies their positions for volumes. Returns the number of faces
/// turned. Throws InputError, naming a face, where no orientation exists.
std::size_t orient_faces(std::vector<Face>& faces, const std::vector<Vec3>& points);

}  // namespace transformesh
