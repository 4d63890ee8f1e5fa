/// PolyData of VTK in XML (file version 1.0), written only: inline base64, so that it is XML which
/// any parser reads. Points without faces become vertex cells. Kept are all columns in their types,
/// named as VTK names what it reads from PLY: `nx ny nz` as Normals, `red green blue (alpha)` as
/// RGB or RGBA, `s t` (or `u v`, `texture_u texture_v`) of vertices as TCoords, any other by its
/// own name; lists where all of a column are equally long, as components.
#pragma once

#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

WriteResult write_vtp(const Document& document);

}  // namespace transformesh
