#include "transformesh/document.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "io/document/edge_element.h"
#include "io/document/missing_colors.h"
#include "io/document/scalar.h"
#include "io/document/unit.h"
#include "io/formats/column_groups.h"
#include "io/formats/obj_labels.h"

namespace transformesh {
namespace {

using Notes = std::vector<std::string>;

void note_misfits(const std::vector<std::string>& names, const std::string& element, Notes& notes) {
  for (const std::string& name : names)
    notes.push_back((element + " property '").append(name) +
                    "' is a list in one input and a number in another: left out of the later one");
}

void append_mesh(Mesh& all, const Mesh& other, Notes& notes) {
  const auto offset = static_cast<Index>(all.positions.size());
  note_misfits(all.vertex_columns.concatenate(other.vertex_columns, all.positions.size(),
                                              other.positions.size()),
               "vertex", notes);
  note_misfits(
      all.face_columns.concatenate(other.face_columns, all.faces.size(), other.faces.size()),
      "face", notes);
  all.positions.insert(all.positions.end(), other.positions.begin(), other.positions.end());
  for (const Face& face : other.faces) {
    all.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
  }
}

/// Appends elements of a document to those of a document with `vertices` vertices.
void append_elements(std::vector<OtherElement>& all, std::vector<OtherElement> others,
                     std::size_t vertices, Notes& notes) {
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) places.emplace(all[i].name, i);
  for (OtherElement& other : others) {
    shift_edges(other, vertices);
    const auto [place, is_new] = places.emplace(other.name, all.size());
    if (is_new) {
      all.push_back(std::move(other));
      continue;
    }
    OtherElement& same = all[place->second];
    note_misfits(same.columns.concatenate(other.columns, same.rows, other.rows), other.name, notes);
    same.rows += other.rows;
  }
}

// Appends those lines of `other` that `all` does not contain. A reference edge and a unit describe
// one mesh, so those of the first document stay.
void append_lines(std::vector<std::string>& all, const std::vector<std::string>& other) {
  std::unordered_set<std::string> present(all.begin(), all.end());
  const bool has_unit = std::any_of(all.begin(), all.end(), is_unit_comment);
  for (const std::string& line : other)
    if (!(has_unit && is_unit_comment(line)) && !line.starts_with("tm:reference-edge") &&
        present.insert(line).second)
      all.push_back(line);
}

/// True if `first` has texture coordinates of vertices, and `second` those of face corners.
bool differ_in_texture(const Mesh& first, const Mesh& second) {
  const ColumnGroup group = texture_group(first.vertex_columns);
  return !group.empty() && is_floating(group[0]->type) && !first.faces.empty() &&
         corner_texture(first.face_columns) == nullptr &&
         corner_texture(second.face_columns) != nullptr;
}

Notes append_separated(Document& all, const Document& other) {
  Notes notes = notes_of_units(unit_of(all), unit_of(other));
  for (std::string& line : notes_of_missing_colors(all.mesh, other.mesh))
    notes.push_back(std::move(line));
  append_elements(all.other_elements, other.other_elements, all.mesh.positions.size(), notes);
  append_mesh(all.mesh, other.mesh, notes);
  for (OtherElement& element : all.other_elements) element.numbered.reset();
  number_edges(all, notes);
  append_lines(all.style.comments, other.style.comments);
  append_lines(all.style.obj_info, other.style.obj_info);
  if (other.style.coordinate == Scalar::float64) all.style.coordinate = Scalar::float64;
  return notes;
}

}  // namespace

std::vector<std::string> append(Document& all, const Document& other) {
  const bool have_labels = have_obj_labels(all, other);
  const bool is_first_changed = differ_in_texture(all.mesh, other.mesh);
  const bool is_other_changed = differ_in_texture(other.mesh, all.mesh);
  if (is_first_changed) make_corner_texture(all.mesh.faces, all.mesh);
  Document changed;
  const bool is_copied = have_labels || is_other_changed;
  if (is_copied) changed = other;
  if (have_labels) separate_obj_labels(all, changed);
  if (is_other_changed) make_corner_texture(changed.mesh.faces, changed.mesh);
  Notes notes = append_separated(all, is_copied ? changed : other);
  if (is_first_changed || is_other_changed)
    notes.emplace_back(
        "texture coordinates of vertices become lists for face corners (texcoord), as in the other "
        "input");
  return notes;
}

const char* name_of(Format format) {
  switch (format) {
    case Format::ply_ascii:
      return "ply-ascii";
    case Format::ply_big:
      return "ply-be";
    case Format::off:
      return "off";
    case Format::obj:
      return "obj";
    case Format::stl_ascii:
    case Format::stl_binary:
      return "stl";
    case Format::glb:
      return "glb";
    case Format::vtp:
      return "vtp";
    case Format::three_mf:
      return "3mf";
    case Format::xyz:
      return "xyz";
    default:
      return "ply";
  }
}

}  // namespace transformesh
