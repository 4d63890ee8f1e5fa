/// OBJ, the polygon format of Wavefront: positions with optional colors (0 to 1), faces, texture
/// coordinates, groups, objects and materials. Normals are dropped with a note.
///
/// Texture coordinates become the face column `texcoord`: lists of (u, v) for each corner, empty
/// for faces without texture coordinates. The type is float if floats reproduce the text. If the
/// texture coordinate of every corner has the number of its vertex, they become the vertex columns
/// `s t` instead. The writer stores `texcoord`, else `s t`, `u v` or `texture_u texture_v`.
///
/// `g`, `o` and `usemtl` become the integer face columns `group`, `object` and `material`. A name
/// that is a number is kept as this number. Other names get numbers from 1, and comments such as
/// `tm:group 1 wing` record them. The number 0 means no name. `mtllib` becomes the comment
/// `tm:mtllib FILE`.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Reads OBJ as read_mesh() does. write_obj() writes OBJ as write_mesh() does; its argument
/// `outlines` is MergedPolygons::outlines. Coordinates are double.
ReadResult read_obj(const Source& source);
WriteResult write_obj(const Document& document, const Column* outlines = nullptr);

}  // namespace transformesh
