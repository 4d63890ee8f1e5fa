/// VTP: VTK PolyData as XML (docs.vtk.org, "VTK XML Formats"). Written in one piece, inline in
/// base64. Read in all encodings and byte orders, compressed by zlib or not, with pieces joined.
/// Vertex columns are PointData, face columns CellData. Normals (nx ny nz), colors (red green blue,
/// with alpha), texture coordinates (s t) and lists of constant length are arrays of several
/// components.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Read and write VTP as read_mesh() and write_mesh() do.
ReadResult read_vtp(const Source& source);
WriteResult write_vtp(const Document& document);

}  // namespace transformesh
