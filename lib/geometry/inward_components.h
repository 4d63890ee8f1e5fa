/// Finds components that are inside out, with the exact signs of their volumes. The volume of a
/// plate that is a few roundings thick is smaller than the rounding errors of Component::volume.
#pragma once

#include <vector>

#include "transformesh/components.h"

namespace transformesh {

/// Returns 1 for each closed component with a negative volume, otherwise 0. Exact for all finite
/// coordinates: uses doubles with an error bound, and exact numbers if these do not decide. O(n).
std::vector<char> inward_components(const Mesh& mesh, const Components& parts);

}  // namespace transformesh
