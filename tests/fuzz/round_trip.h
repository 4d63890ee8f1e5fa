/// Judges the readers and writers of meshes. A mesh that is read is written in every format and
/// read again. The bits must be the same, as far as the format can represent them.
#pragma once

#include <cmath>
#include <cstring>
#include <vector>

#include "fuzz/fuzz.h"
#include "io/formats/file_format.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh::fuzz {

inline bool is_same(double first, double second) {
  const bool are_nan = std::isnan(first) && std::isnan(second);
  return are_nan || (first == second && std::signbit(first) == std::signbit(second));
}

inline bool is_same(const Vec3& first, const Vec3& second) {
  return is_same(first.x(), second.x()) && is_same(first.y(), second.y()) &&
         is_same(first.z(), second.z());
}

inline bool is_same(const Columns& first, const Columns& second) {
  if (first.columns.size() != second.columns.size()) return false;
  for (std::size_t i = 0; i < first.columns.size(); ++i) {
    const Column& a = first.columns[i];
    const Column& b = second.columns[i];
    if (a.name != b.name || a.type != b.type || a.values.size() != b.values.size()) return false;
    if (a.list_offsets != b.list_offsets) return false;
    const bool has_sign_of_zero = a.type == Scalar::float32 || a.type == Scalar::float64;
    for (std::size_t row = 0; row < a.values.size(); ++row) {
      const bool are_same =
          has_sign_of_zero ? is_same(a.values[row], b.values[row]) : a.values[row] == b.values[row];
      if (!are_same) return false;
    }
  }
  return true;
}

inline bool is_stl(Format format) {
  return format == Format::stl_ascii || format == Format::stl_binary;
}

/// STL has corners instead of vertices.
inline void compare_meshes(const Mesh& given, const Mesh& again, Format format) {
  demand(given.faces.size() == again.faces.size(), "another number of faces");
  if (!is_stl(format)) {
    demand(given.positions.size() == again.positions.size(), "another number of vertices");
    demand(given.faces == again.faces, "other faces");
    for (std::size_t v = 0; v < given.positions.size(); ++v)
      demand(is_same(given.positions[v], again.positions[v]), "another position");
    return;
  }
  for (std::size_t f = 0; f < given.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      demand(is_same(given.positions[given.faces[f][i]], again.positions[again.faces[f][i]]),
             "another corner");
}

/// Carriage returns inside of a comment become blanks.
inline std::string lines_of(const std::vector<std::string>& comments) {
  std::string lines;
  for (const std::string& comment : comments) lines += comment + '\n';
  std::replace(lines.begin(), lines.end(), '\r', ' ');
  return lines;
}

/// PLY holds everything.
inline void compare_documents(const Document& given, const Document& again) {
  const Mesh& mesh = given.mesh;
  demand(is_same(mesh.vertex_columns, again.mesh.vertex_columns), "other vertex columns");
  demand(is_same(mesh.face_columns, again.mesh.face_columns), "other face columns");
  demand_same(lines_of(given.style.comments), lines_of(again.style.comments), "other comments");
  demand_same(lines_of(given.style.obj_info), lines_of(again.style.obj_info), "other obj_info");
  demand(given.other_elements.size() == again.other_elements.size(), "other elements");
  for (std::size_t i = 0; i < given.other_elements.size(); ++i)
    demand(given.other_elements[i].name == again.other_elements[i].name &&
               given.other_elements[i].rows == again.other_elements[i].rows &&
               is_same(given.other_elements[i].columns, again.other_elements[i].columns),
           "another element");
}

/// Writing twice gives the same bytes. Only ASCII text in the header of binary STL is a name, and
/// OFF without vertices has no colors.
inline void write_and_compare(const Document& document) {
  const Format format = document.style.format;
  const std::string bytes = write_mesh(document).bytes;
  const std::string name = "written." + std::string(name_of(format));
  const Document again = read_mesh(bytes, name).document;
  demand(again.style.format == format, "another format");
  compare_meshes(document.mesh, again.mesh, format);
  if (is_ply(format)) compare_documents(document, again);
  if (format == Format::stl_binary) return;
  if (format == Format::off && document.mesh.positions.empty()) return;
  demand_same(bytes, write_mesh(again).bytes, "other bytes when written again");
}

/// Coordinates that floats cannot hold are refused.
inline void write_as(Document document, Format format, Scalar coordinate) {
  try {
    set_format(document, format, coordinate);
    write_and_compare(document);
  } catch (const GoalError&) {
  }
}

/// These formats hold less or other data than PLY; the data that they do hold must be read again.
inline void write_and_read(Document document, Format format) {
  try {
    set_format(document, format);
    const std::string bytes = write_mesh(document).bytes;
    if (document.mesh.positions.empty()) return;
    const Mesh again = read_mesh(bytes, "written").document.mesh;
    const auto is_kept = [](const Face& face) { return !is_collapsed(face); };
    const auto& faces = document.mesh.faces;
    const auto kept = static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), is_kept));
    demand(format == Format::xyz || again.faces.size() >= kept, "fewer faces");
  } catch (const GoalError&) {
  }
}

/// Reads a mesh and judges the result; input may be refused.
inline void check_mesh_file(std::string_view bytes, const std::string& name) {
  ReadResult result;
  try {
    result = read_mesh(bytes, name);
  } catch (const InputError&) {
    return;
  }
  const Document& document = result.document;
  for (const Face& face : document.mesh.faces)
    for (const Index corner : face)
      demand(corner < document.mesh.positions.size(), "an index out of range");
  const bool keeps_bytes = is_ply(document.style.format) || is_stl(document.style.format) ||
                           document.style.format == Format::off ||
                           document.style.format == Format::obj;
  if (keeps_bytes) write_and_compare(document);
  for (const Format format : {Format::glb, Format::three_mf, Format::vtp, Format::xyz})
    write_and_read(document, format);
  for (const Format format : {Format::ply_ascii, Format::ply_little, Format::ply_big, Format::off,
                              Format::obj, Format::stl_ascii, Format::stl_binary})
    for (const Scalar coordinate : {Scalar::float64, Scalar::float32})
      write_as(document, format, coordinate);
}

}  // namespace transformesh::fuzz
