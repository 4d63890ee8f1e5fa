/// Chooses the format in which a document is written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/document/round_as_written.h"
#include "transformesh/document.h"

namespace transformesh {

/// Returns the format in which to write. `wanted` is ply, ply-ascii, ply-be, off, obj, stl, glb,
/// vtp, 3mf or xyz. If `wanted` is empty, the ending of `name` decides, in upper or lower case. If
/// that is none of written_endings(), the format is the input's, or PLY for input in OBJ or STL.
/// The encoding is the input's if the formats are the same.
Format format_for(Format input, std::string_view wanted, std::string_view name);

/// Endings of names that choose a format: .ply .off .obj .stl .glb .vtp .3mf .xyz.
const std::vector<std::string>& written_endings();

/// Returns the ending of a file's name, with its dot, if it is not among `known`, else nothing. An
/// ending longer than four characters, such as the end of a random name, does not count.
std::string unknown_ending(std::string_view name, const std::vector<std::string>& known);

/// Changes the document's format, and its type of coordinates: by default float for STL and GLB,
/// double for OFF, OBJ, VTP, 3MF and XYZ, unchanged for PLY. Rounds positions and returns the
/// number of faces that collapse, as round_positions() does.
std::size_t set_format(Document& document, Format format, std::optional<Scalar> coordinate = {});

/// True if coordinates of the format are always floats.
bool holds_floats(Format format);

/// True if the format is text, which may be written to a terminal.
bool is_text(Format format);

}  // namespace transformesh
