/// Areas of the connected components of a mesh.
#pragma once

#include <vector>

#include "transformesh/components.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the area of each component. Components of an open mesh are compared by area, because
/// they enclose no volume. O(faces).
std::vector<double> component_areas(const Mesh& mesh, const Components& parts);

}  // namespace transformesh
