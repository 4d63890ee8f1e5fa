/// STL of stereolithography, as text and binary: separate triangles with float coordinates. Each
/// face gets its own three vertices; stitch() joins them. The name in the first line or in the
/// header becomes a comment; attribute bytes become the face column `attribute`.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Size of a facet of binary STL in bytes: 12 floats and a 16-bit attribute.
inline constexpr std::size_t stl_facet_size = 50;

/// Readers of text and binary STL, which work as read_mesh() does, and a writer, which works as
/// write_mesh() does.
ReadResult read_stl_text(const Source& source);
ReadResult read_stl_binary(const Source& source);
WriteResult write_stl(const Document& document);

}  // namespace transformesh
