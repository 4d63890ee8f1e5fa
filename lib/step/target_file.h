/// Targets as files: meshes in any format that is read, points as PLY without faces or as text
/// (point_text.h).
#pragma once

#include <string>
#include <string_view>

#include "transformesh/document.h"
#include "transformesh/mesh_io.h"
#include "transformesh/target.h"

namespace transformesh {

/// Binary PLY that reads back as the same target, and sooner: points with their normals,
/// thickness as the vertex column `gap`, faces in spatial order; comments state which.
std::string write_target(const Target& target);

}  // namespace transformesh
