/// VTP: VTK PolyData as XML (docs.vtk.org, "VTK XML Formats"). Writes one piece, with arrays inline
/// in base64. Reads all encodings and byte orders, with or without zlib compression; joins pieces.
/// Vertex columns are PointData, face columns CellData. Normals (nx ny nz), colors (red green blue,
/// with alpha), texture coordinates (s t) and lists of constant length are arrays of several
/// components.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Reads VTP as read_mesh() does. write_vtp() writes VTP as write_mesh() does.
ReadResult read_vtp(const Source& source);
WriteResult write_vtp(const Document& document);

}  // namespace transformesh
