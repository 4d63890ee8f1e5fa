/// Notes on colors that one of two meshes lacks, and that become white when the meshes are joined.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns one line for vertices and one line for faces, each only if exactly one of the meshes has
/// such colors.
std::vector<std::string> notes_of_missing_colors(const Mesh& first, const Mesh& second);

}  // namespace transformesh
