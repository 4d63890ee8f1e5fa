/// A mesh with all other contents of its file, so that it can be written as it was read.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

// clang-format off
enum class Format { ply_ascii, ply_little, ply_big, off, obj, stl_ascii, stl_binary, glb, vtp,
                    three_mf, xyz };
// clang-format on

/// A PLY element other than vertices and faces. `edge` is dropped if its vertices have changed.
struct OtherElement {
  std::string name;
  std::size_t rows = 0;
  Columns columns;
  std::optional<std::array<std::size_t, 3>> numbered = {};  ///< vertices (count, hashes) when read
};

/// Encoding of the file. The defaults are the format in which programs pass meshes through pipes.
struct Style {
  Format format = Format::ply_little;
  Scalar coordinate = Scalar::float64;       ///< type of positions in the file: float32 or float64
  std::vector<std::string> comments;         ///< texts of comments, without the keyword `comment `
  std::vector<std::string> obj_info;         ///< texts of obj_info lines, without this keyword
  std::string face_list = "vertex_indices";  ///< PLY list of face corners, or vertex_index
  Scalar face_list_count = Scalar::uint8, face_list_index = Scalar::int32;
  std::size_t position_column = 0;   ///< number of vertex properties before x y z
  std::size_t face_list_column = 0;  ///< number of face properties before the index list
  /// Names of the PLY elements in the order of the file; empty: vertex, face, then the others. If
  /// `face` is missing and the mesh has no faces (a point cloud), no face element is written.
  std::vector<std::string> element_order;
  bool is_from_stl = false;       ///< lengths are in millimeters, if no comment states a unit
  bool sized_type_names = false;  ///< PLY types are float32, uint8, not float, uchar
  bool keeps_polygons = false;    ///< polygons are written as they were read (ReadOptions)
};

struct Document {
  Mesh mesh;
  Style style;
  std::vector<OtherElement> other_elements;
  std::string texture = {};  ///< PNG file embedded in GLB; other formats refer to a separate file
};

/// Appends vertices, faces, columns and further elements in their order. Vertex numbers of faces
/// and of the element `edge` are shifted. A column gets a type that holds the values of both;
/// missing values are zero. Comments are joined without repetition; the first reference edge stays.
/// Returns one line for each column that is a list in one document and a number in the other. O(n).
std::vector<std::string> append(Document& all, const Document& other);

/// Returns the name of a format: ply, ply-ascii, ply-be, off, obj, stl, glb, vtp, 3mf or xyz.
const char* name_of(Format format);

}  // namespace transformesh
