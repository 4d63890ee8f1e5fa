/// A mesh together with everything else its file said, so that it can be written the way it came:
/// same in, same out. Algorithms see the Mesh only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

enum class Format { ply_ascii, ply_little, ply_big, off, obj, stl_ascii, stl_binary, glb, vtp };

/// A PLY element other than vertices and faces, kept as it is.
struct OtherElement {
  std::string name;
  std::size_t rows = 0;
  Columns columns;
};

/// How the file was written. The defaults are the pipe format.
struct Style {
  Format format = Format::ply_little;
  Scalar coordinate = Scalar::float64;       ///< float32 or float64
  std::vector<std::string> comments;         ///< without the keyword `comment `
  std::vector<std::string> obj_info;         ///< without the keyword `obj_info `
  std::string face_list = "vertex_indices";  ///< or vertex_index, as it came
  Scalar face_list_count = Scalar::uint8;
  Scalar face_list_index = Scalar::int32;
  std::size_t position_column = 0;   ///< vertex properties that come before x y z
  std::size_t face_list_column = 0;  ///< face properties that come before the index list
  /// Names of the PLY elements in the order of the file; empty: vertex, face, then the others.
  /// Where it leaves out `face`, none is written while the mesh has no faces (a point cloud).
  std::vector<std::string> element_order;
  bool sized_type_names = false;  ///< PLY types are spelt float32, uint8 and not float, uchar
};

struct Document {
  Mesh mesh;
  Style style;
  std::vector<OtherElement> other_elements;
  std::string texture = {};  ///< a PNG file that GLB holds; other formats have it beside them
};

/// Options of read_mesh().
struct ReadOptions {
  /// Throws InputError for content that is otherwise dropped or skipped with a note: values that
  /// are not finite, unknown lines, a missing end.
  bool strict = false;
};

/// Of read_mesh().
struct ReadResult {
  Document document;
  std::vector<std::string> notes;  ///< what was changed on the way in, one line each
  /// Index of the note that the faces share no vertices, as in STL.
  std::optional<std::size_t> soup_note = {};
};

/// Of write_mesh().
struct WriteResult {
  std::string bytes;
  std::vector<std::string> notes;  ///< what the format cannot hold, one line each
};

}  // namespace transformesh
