/// Points as text: lines of x y z, or of x y z nx ny nz if vertices have normals, with comments
/// after `#`. point_text.h reads them.
#pragma once

#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Writes XYZ as write_mesh() does.
WriteResult write_xyz(const Document& document);

}  // namespace transformesh
