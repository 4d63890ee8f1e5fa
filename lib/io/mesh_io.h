/// Bytes to mesh and back. The format is detected from the first bytes (PLY, OFF and its variants,
/// STL by `solid` or by its size, OBJ by its keywords); `name` only helps where bytes cannot
/// decide, and is what messages call the input. Polygons are triangulated without folds. A header
/// is a claim, not a promise: memory grows with the bytes that are there, never with a count that a
/// header states.
///
/// Reading checks every index and every number: an index out of range and a count that the data
/// does not hold are InputErrors with line or byte offset. Vertices with a coordinate that is not
/// finite are dropped with the faces that use them; normals and colors that are not finite become
/// 0. Notes count both, and what else is skipped; strict reading refuses it. Cost: linear.
/// Deterministic, locale-free. Writing what was read gives the same mesh bit for bit; ASCII numbers
/// are the shortest that read back the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/document/document.h"

namespace transformesh {

/// Throws InputError. An input without a single byte says so. A mesh may be empty of faces.
ReadResult read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& = {});

/// Writes in document.style. Coordinates are rounded to style.coordinate where the format has a
/// choice; STL and GLB hold float. Throws GoalError for coordinates that are not finite, or become
/// so by rounding.
WriteResult write_mesh(const Document& document);

/// The mesh of a file (`-`: stdin), and a file of it in double precision, complete or not at all,
/// in the format of its name, else PLY. Throw what reading and writing throw, and OutputError.
Mesh read_mesh_file(const std::string& path);
void write_mesh_file(const std::string& path, const Mesh& mesh);

/// The format in which to write: `wanted` says ply, ply-ascii, ply-be, off, obj, stl, glb or vtp;
/// where it is empty the extension of the name decides, one of written_endings() in any case; else
/// it is the input's, or PLY for what comes as OBJ or STL. The encoding is the input's where the
/// formats are the same.
Format format_for(Format input, std::string_view wanted, std::string_view name);

/// The endings of names that choose a format: .ply .off .obj .stl .glb .vtp.
const std::vector<std::string>& written_endings();

/// The ending of a file's name that no format has, with its dot; empty where the format has it or
/// there is none. What is longer than four characters, as a random name's end, is no ending.
std::string unknown_ending(std::string_view name, const std::vector<std::string>& known);

/// Makes the document one of that format, with coordinates of the type wanted: by default floats
/// for STL and GLB, doubles for OFF, OBJ and VTP, as they are for PLY. Rounds as round_positions()
/// does, so that what is computed is what will be read back, and returns what that returns.
std::size_t set_format(Document& document, Format format, std::optional<Scalar> coordinate = {});

/// For messages and reports: ply, ply-ascii, ply-be, off, obj, stl, glb, vtp.
const char* name_of(Format format);

/// Whether coordinates of the format are floats, whatever they were.
bool holds_floats(Format format);

/// Whether the format is text, which may go to a terminal.
bool is_text(Format format);

/// Rounds coordinates to the scalar type in which they will be written, so that what is computed is
/// what is read back. Returns how many faces collapse by that; throws GoalError
/// where most do, or turn.
std::size_t round_positions(Mesh& mesh, Scalar coordinate);

/// Makes of a document what reading gives after write_mesh() in a PLY format: coordinates and
/// columns rounded to their types. Stages that follow each other in one process then make the same
/// bytes as programs on pipes. Throws GoalError as write_mesh() does.
void round_as_written(Document& document);

}  // namespace transformesh
