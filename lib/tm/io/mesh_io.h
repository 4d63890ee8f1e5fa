/// Bytes to mesh and back. The format is told from the first bytes (PLY, OFF and its variants, STL
/// by `solid` or by its size, OBJ by its keywords); `name` only helps where bytes cannot decide,
/// and is what messages call the input. Polygons are cut into fans. A header is a claim, not a
/// promise: memory grows with the bytes that are there, never with a count that a header states.
///
/// Reading checks every index and every number: an index out of range, a count that the data does
/// not hold, NaN or infinity in a coordinate are InputErrors with line or byte offset.
/// Cost: linear. Deterministic, locale-free. Writing what was read gives the same mesh bit for bit;
/// ASCII numbers are the shortest that read back the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tm/io/document.h"

namespace transformesh {

struct ReadResult {
  Document document;
  std::vector<std::string> notes;  ///< what was changed on the way in, one line each
};

struct WriteResult {
  std::string bytes;
  std::vector<std::string> notes;  ///< what the format cannot hold, one line each
};

/// Throws InputError. An input without a single byte says so. A mesh may be empty of faces.
ReadResult read_mesh(std::string_view bytes, const std::string& name);

/// Writes in document.style. Coordinates are rounded to style.coordinate where the format has a
/// choice; STL holds float. Throws GoalError for coordinates that are not finite, or become so by
/// rounding.
WriteResult write_mesh(const Document& document);

/// The mesh of a file (`-`: stdin), and a file of it in double precision, complete or not at all,
/// in the format of its name, else PLY. Throw what reading and writing throw, and OutputError.
Mesh read_mesh_file(const std::string& path);
void write_mesh_file(const std::string& path, const Mesh& mesh);

/// The format that a file name's extension asks for: .ply .off .obj .stl, any case.
/// `encoding_like` supplies the encoding of PLY where it is one. False for other extensions.
bool format_of_name(std::string_view name, Format encoding_like, Format& format);

/// Rounds coordinates to the scalar type in which they will be written, so that what is computed is
/// what is read back. Returns how many faces collapse by that; throws GoalError
/// where most do, or turn.
std::size_t round_positions(Mesh& mesh, Scalar coordinate);

/// Makes of a document what reading gives after write_mesh() in a PLY format: coordinates and
/// columns rounded to their types. Stages that follow each other in one process then make the same
/// bytes as programs on pipes. Throws GoalError as write_mesh() does.
void round_as_written(Document& document);

}  // namespace transformesh
