/// OBJ, the polygon files of Wavefront: positions with optional colors (0 to 1), and faces.
/// Normals, texture coordinates, groups and materials are left out, which the notes say.
#pragma once

#include "tm/io/mesh_io.h"
#include "tm/io/source.h"

namespace transformesh {

/// See read_mesh and write_mesh. Coordinates are double.
ReadResult read_obj(const Source& source);
WriteResult write_obj(const Document& document);

}  // namespace transformesh
