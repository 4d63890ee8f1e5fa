/// In which format and scalar type a mesh leaves the program.
#pragma once

#include "common_options.h"
#include "tm/io/document.h"

namespace transformesh::tool {

/// As --format or the name given with -o says, else that of the input.
Format output_format(Format input, const CommonOptions& options);

/// Changes the style as -o, --format, --float and --double ask, and rounds the coordinates where
/// the output will hold floats: what is computed is what will be read back. Returns how many
/// faces collapse by that; throws GoalError where most do.
std::size_t apply_output_style(Document& document, const CommonOptions& options);

/// Whether the format is text, which may go to a terminal.
bool is_text(Format format);

/// For messages and reports: ply, ply-ascii, ply-be, off, obj, stl.
const char* format_name(Format format);

}  // namespace transformesh::tool
