/// The columns of a new vertex on a face: barycentric weights of the face's corners.
#pragma once

#include "tm/mesh/mesh.h"

namespace transformesh {

/// Weights are in [0, 1] and sum to 1, whatever rounding did to the position.
RowBlend row_on_face(const Mesh& mesh, Index face, const Vec3& position);

}  // namespace transformesh
