/// Writes the target of a morph, a mesh or a point set, to a file. The file contains precomputed
/// data, so that read_target() reads it faster than other files.
#pragma once

#include <string>
#include <string_view>

#include "transformesh/document.h"
#include "transformesh/mesh_io.h"
#include "transformesh/target.h"

namespace transformesh {

/// Returns a binary PLY file. From this file, read_target() restores the same target without
/// recomputing anything. Faces are in spatial order, and points have normals. If the local
/// thickness of the target was measured, it is the vertex column `gap`. Comments in the header
/// state whether faces are in spatial order and whether the thickness was measured.
std::string write_target(const Target& target);

}  // namespace transformesh
