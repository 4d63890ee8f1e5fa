/// OFF, the Object File Format of Geomview, and its variants with colors (COFF), normals (NOFF) and
/// texture coordinates (STOFF), as text. Additional values become the columns red green blue alpha,
/// nx ny nz and s t. A face color that is a single number becomes color_index.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if a word starts an OFF file. Examples are OFF, COFF and STCNOFF. The word may end with a
/// count, without a blank before it.
bool is_off_keyword(std::string_view word);

/// Reads OFF as read_mesh() does. write_off() writes OFF as write_mesh() does; its argument
/// `outlines` is MergedPolygons::outlines. Coordinates are double.
ReadResult read_off(const Source& source);
WriteResult write_off(const Document& document, const Column* outlines = nullptr);

}  // namespace transformesh
