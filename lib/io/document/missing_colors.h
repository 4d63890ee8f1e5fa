/// Colors that one of two meshes lacks, and that become white where the meshes are joined.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// One line for vertices and one for faces, if only one of two meshes has colors of theirs.
std::vector<std::string> notes_of_missing_colors(const Mesh& first, const Mesh& second);

}  // namespace transformesh
