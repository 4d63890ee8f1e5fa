/// Limits of the extent of two meshes within which their distances are computed. Cost: O(n).
#pragma once

#include <string>

#include "transformesh/mesh.h"

namespace transformesh {

/// Throws InputError if the bounding box of both meshes together is so large that products of areas
/// would overflow, or so small that they would vanish. An extent of 0 is allowed. The error says
/// that the meshes are too large or too small for the `purpose`, such as "to compare".
void check_common_extent(const Mesh& mesh, const Mesh& reference, const std::string& purpose);

}  // namespace transformesh
