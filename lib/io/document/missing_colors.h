/// Notes on colors that one of two meshes lacks, and that become white when the meshes are joined.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns notes about missing colors: one line for vertices and one for faces, each only if
/// exactly one of the two meshes has such colors.
std::vector<std::string> notes_of_missing_colors(const Mesh& first, const Mesh& second);

}  // namespace transformesh
