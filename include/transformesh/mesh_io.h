/// Reads and writes meshes: PLY, OFF and its variants, OBJ, STL, glTF (written as GLB), 3MF, VTP
/// and points as text (XYZ); reads VTK and PCD as well.
///
/// Bytes compressed by gzip are expanded. The format is detected from the first bytes; the name
/// helps only if bytes cannot decide. Polygons are triangulated without folds. Memory grows with
/// the bytes that are there, never with a count that a header states. Every index and number is
/// checked. Vertices with a coordinate that is not finite are dropped with the faces that use them;
/// normals and colors that are not finite become 0. A note counts what was dropped or skipped.
///
/// Writing what was read gives the same mesh bit for bit. ASCII numbers are the shortest that read
/// back the same. Cost: O(n). Deterministic; independent of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/document.h"
#include "transformesh/errors.h"

namespace transformesh {

struct ReadOptions {
  /// Throw InputError for content that is otherwise dropped or skipped with a note: values that are
  /// not finite, unknown lines, a missing end.
  bool strict = false;
  /// Folder of the files that a .gltf file names; empty: such files are refused.
  std::string folder = {};
};

struct ReadResult {
  Document document;
  std::vector<std::string> notes;             ///< changes while reading, one line each
  std::optional<std::size_t> soup_note = {};  ///< index of the note that faces share no vertices
};

struct WriteResult {
  std::string bytes;
  std::vector<std::string> notes;  ///< what the format cannot hold, one line each
};

/// Reads a mesh, which may have no faces. `name` is the name of the input in messages. Throws
/// InputError, with line or byte offset, for an index out of range, for a count that the data does
/// not hold, and for bytes that are no mesh.
ReadResult read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& = {});

/// Writes in `document.style`. Coordinates are rounded to `style.coordinate` if the format has a
/// choice; STL and GLB hold floats. Throws GoalError for coordinates that are not finite or become
/// infinite by rounding.
WriteResult write_mesh(const Document& document);

/// Reads the mesh of a file; `-` is standard input. Throws as read_mesh() does.
Mesh read_mesh_file(const std::string& path);

/// Writes a file in double precision, complete or not at all, in the format of the name's ending,
/// else PLY. Throws as write_mesh() does, and OutputError.
void write_mesh_file(const std::string& path, const Mesh& mesh);

}  // namespace transformesh
