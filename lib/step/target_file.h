/// Targets as files: meshes in any format that is read, points as PLY without faces or as text
/// (point_text.h).
#pragma once

#include <string>
#include <string_view>

#include "io/document/document.h"
#include "step/target.h"

namespace transformesh {

/// The faces of a mesh come in spatial order, without their columns. Throws InputError as
/// read_mesh, read_point_text and make_target do.
Target read_target(std::string_view bytes, const std::string& name, const ReadOptions& = {});

/// The mesh or the points of such a file, for what is no target.
ReadResult read_mesh_or_points(std::string_view bytes, const std::string& name,
                               const ReadOptions& = {});

/// Binary PLY that reads back as the same target, and sooner: points with their normals,
/// thickness as the vertex column `gap`, faces in spatial order; comments state which.
std::string write_target(const Target& target);

}  // namespace transformesh
