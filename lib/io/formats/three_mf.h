/// 3MF: 3D Manufacturing Format, Core Specification 1.3, Materials and Properties 1.2, Production
/// 1.1 (3MF Consortium; ISO/IEC 25422:2025).
///
/// Reading joins all items of the build in one mesh, transformed, with the unit as the comment
/// `tm:unit`. Base materials and color groups become colors of vertices if all faces at each vertex
/// agree, otherwise of faces.
///
/// Writes one object and one item, in the unit of the comment or in millimeters. Colors of
/// vertices, or else of faces, become a color group if their type is uint8. Coordinates are
/// doubles. Other comments become the metadata `Description`.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Reads 3MF as read_mesh() does. Throws InputError for damaged files, encrypted parts, and cyclic
/// components.
ReadResult read_three_mf(const Source& source);

/// Writes 3MF as write_mesh() does. Throws GoalError for a mesh without faces, which 3MF cannot
/// represent.
WriteResult write_three_mf(const Document& document);

}  // namespace transformesh
