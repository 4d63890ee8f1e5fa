/// OBJ, the polygon files of Wavefront: positions with optional colors (0 to 1), faces, texture
/// coordinates, groups, objects and materials. Normals are left out, which the notes say.
///
/// Texture coordinates are the face column `texcoord`, u and v of each corner in a list that is
/// empty where a face has none; floats where those give back the text. Where every corner has the
/// texture coordinates of its vertex's number, they are the vertex columns `s t` instead. Written
/// are `texcoord`, else `s t`, `u v` or `texture_u texture_v`.
///
/// `g`, `o` and `usemtl` are the integer face columns `group`, `object` and `material`: a name that
/// is a number is that number, others get numbers from 1 on, and comments `tm:group 1 wing` say
/// which. 0 is none. `mtllib` is the comment `tm:mtllib FILE`.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// See read_mesh and write_mesh. Coordinates are double.
ReadResult read_obj(const Source& source);
WriteResult write_obj(const Document& document);

}  // namespace transformesh
