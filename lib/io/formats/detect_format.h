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

/// The name's extension decides only where bytes cannot: OFF without its keyword, binary STL of the
/// wrong size, files of comments. Throws InputError showing the first bytes where nothing fits.
FileKind detect_format(const Source& source);

/// Throws InputError of kind unknown_format that shows the first bytes and names all formats.
[[noreturn]] void refuse_unknown_format(const Source& source);

/// Whether the bytes have the size that they say as binary STL, whose header may be anything.
bool is_binary_stl_by_size(std::string_view bytes);

}  // namespace transformesh
