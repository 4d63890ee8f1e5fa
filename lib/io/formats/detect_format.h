/// Decides the format of a mesh from its first bytes.
#pragma once

#include "io/streams/source.h"

namespace transformesh {

enum class FileKind {
  ply,
  off,
  obj,
  stl_ascii,
  stl_binary,
  gltf,
  three_mf,
  vtk,
  vtp,
  pcd,
  points,
  point_table
};

/// Detects the format. The extension of the name decides only if the bytes are ambiguous: OFF
/// without its keyword, binary STL of a wrong size, files of comments only. Throws InputError,
/// showing the first bytes, if no format fits.
FileKind detect_format(const Source& source);

/// Throws InputError (unknown_format), whose message shows the first bytes of the file and lists
/// all formats.
[[noreturn]] void refuse_unknown_format(const Source& source);

/// True if the size of the file matches the number of facets that a binary STL file states. The 80
/// bytes of header text may have any content.
bool is_binary_stl_by_size(std::string_view bytes);

}  // namespace transformesh
