/// VTP: PolyData of VTK as XML (docs.vtk.org, "VTK XML Formats"). Written in one piece, inline in
/// base64; read in all encodings and byte orders, compressed by zlib or not, with pieces joined.
/// Columns of vertices are PointData and columns of faces CellData. Normals (nx ny nz), colors (red
/// green blue, with alpha) and texture coordinates (s t) are arrays of several components. So are
/// lists of one length for all rows.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// See read_mesh and write_mesh.
ReadResult read_vtp(const Source& source);
WriteResult write_vtp(const Document& document);

}  // namespace transformesh
