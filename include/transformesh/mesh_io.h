/// Reads and writes meshes: PLY, OFF and its variants, OBJ, STL, glTF (written as GLB), 3MF, VTP
/// and points as text (XYZ); also reads VTK and PCD.
///
/// Data compressed by gzip is decompressed. The format is detected from the first bytes; the file
/// name decides only if the bytes are ambiguous. Polygons are triangulated without folds. Memory is
/// proportional to the size of the data, never to a count in a header. Every index and number is
/// checked. Vertices with a non-finite coordinate are dropped with the faces that use them.
/// Non-finite normals and colors become 0. A note counts what was dropped or skipped.
///
/// Writing a mesh that was read gives the same mesh bit for bit. ASCII numbers are the shortest
/// that read back as the same value. Cost: O(n). Deterministic; independent of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/document.h"
#include "transformesh/errors.h"

namespace transformesh {

struct ReadOptions {
  /// Throw InputError for content that is otherwise dropped or skipped with a note: non-finite
  /// values, unknown lines, a missing end.
  bool strict = false;
  std::string folder = {};     ///< folder of the files that a .gltf file refers to; empty: none
  bool keep_polygons = false;  ///< PLY, OFF and OBJ are written with the polygons that were read
};

struct ReadResult {
  Document document;
  std::vector<std::string> notes;             ///< changes made while reading, one line each
  std::optional<std::size_t> soup_note = {};  ///< index in `notes`: faces share no vertices
};

struct WriteResult {
  std::string bytes;
  std::vector<std::string> notes;  ///< data that the format cannot store, one line each
};

/// Reads a mesh, which may have no faces. `name` is the name of the input in messages. Throws
/// InputError, with line or byte offset, for an index out of range, for a count that exceeds the
/// data, and for bytes that are not a mesh.
ReadResult read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& = {});

/// Writes in `document.style`. Coordinates are rounded to `style.coordinate` if the format allows
/// both; STL and GLB store floats. Throws GoalError for coordinates that are not finite or become
/// infinite by rounding.
WriteResult write_mesh(const Document& document);

/// Reads the mesh of a file; `-` is standard input. Throws as read_mesh() does.
Mesh read_mesh_file(const std::string& path);

/// Writes a file in double precision, complete or not at all. The extension decides the format;
/// default: PLY. Throws as write_mesh() does, and OutputError.
void write_mesh_file(const std::string& path, const Mesh& mesh);

}  // namespace transformesh
