/// What every way of wrapping points promises.
#pragma once

#include "tm/mesh/mesh.h"

namespace transformesh {

/// Turns a mesh that is inside out. Throws GoalError unless it is a closed, oriented 2-manifold.
void check_wrap(Mesh& mesh);

}  // namespace transformesh
