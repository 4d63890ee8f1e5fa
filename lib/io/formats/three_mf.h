/// 3MF: 3D Manufacturing Format, Core Specification 1.3, Materials and Properties 1.2,
/// Production 1.1 (3MF Consortium; ISO/IEC 25422:2025). All items of the build are joined in one
/// mesh, moved by their transforms, with the unit as the comment `tm:unit`. Base materials and
/// color groups are colors of vertices if all faces at a vertex agree, else of faces.
///
/// Written are one object and one item, with the unit of the comment, else millimeter. Colors in
/// bytes, of vertices or else of faces, become a color group. Coordinates are doubles. Other
/// comments are the metadata `Description`.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// See read_mesh. Throws InputError for damage, for encrypted parts, and for components that
/// contain themselves.
ReadResult read_three_mf(const Source& source);

/// Throws GoalError for a mesh without faces: 3MF holds objects to be made, and no points.
WriteResult write_three_mf(const Document& document);

}  // namespace transformesh
