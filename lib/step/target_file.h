/// Writes targets to files that read_target() reads faster than other meshes or point sets.
#pragma once

#include <string>
#include <string_view>

#include "transformesh/document.h"
#include "transformesh/mesh_io.h"
#include "transformesh/target.h"

namespace transformesh {

/// Returns a binary PLY file, from which read_target() makes the same target without preparation.
/// Faces are in spatial order; points have normals; the thickness, if measured, is the vertex
/// column `gap`. Comments in the header state the spatial order and the measured thickness.
std::string write_target(const Target& target);

}  // namespace transformesh
