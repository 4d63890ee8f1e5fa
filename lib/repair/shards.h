/// Components that are too small to be parts of a model: crumbs of cut faces. O(n).
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the least area that a component must have to stay; 0 if all may stay.
double least_area(const Mesh& mesh);

}  // namespace transformesh
