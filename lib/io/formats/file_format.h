/// Chooses the format in which a document is written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/coordinate_spacing.h"
#include "transformesh/document.h"

namespace transformesh {

/// Returns the output format. `wanted` is ply, ply-ascii, ply-be, off, obj, stl, glb, vtp, 3mf or
/// xyz. If `wanted` is empty, the extension of `name` decides, in upper or lower case. If the
/// extension is not one of written_endings(), the format is the input's, or PLY for OBJ and STL
/// input. If input and output have the same format, the encoding is the input's.
Format format_for(Format input, std::string_view wanted, std::string_view name);

/// Returns the extensions that select a format: .ply .off .obj .stl .glb .vtp .3mf .xyz.
const std::vector<std::string>& written_endings();

/// Returns the extension of a file name, with its dot, if it is not in the list `known`. Returns
/// nothing if it is. Extensions of more than four characters, such as the end of a random name, are
/// ignored.
std::string unknown_ending(std::string_view name, const std::vector<std::string>& known);

/// Sets the document's format and type of coordinates. Default type: float for STL and GLB, double
/// for OFF, OBJ, VTP, 3MF and XYZ, unchanged for PLY. Rounds positions and returns the number of
/// faces that collapse, as round_positions() does.
std::size_t set_format(Document& document, Format format, std::optional<Scalar> coordinate = {});

/// True for the three encodings of PLY.
bool is_ply(Format format);

/// True if the format stores coordinates as float only.
bool holds_floats(Format format);

/// True if the format is text and may be written to a terminal.
bool is_text(Format format);

}  // namespace transformesh
