/// STL of stereolithography, as text and as bytes: triangles that share nothing, in float. They are
/// read as what they are, three vertices for each face; stitch() joins them. The name in the first
/// line or header is a comment; bytes for attributes become the face column `attribute`.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// See read_mesh and write_mesh.
ReadResult read_stl_text(const Source& source);
ReadResult read_stl_binary(const Source& source);
WriteResult write_stl(const Document& document);

}  // namespace transformesh
