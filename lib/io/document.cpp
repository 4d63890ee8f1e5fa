#include "transformesh/document.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "io/document/edge_element.h"
#include "io/document/missing_colors.h"
#include "io/document/unit.h"
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

std::vector<std::string> append_separated(Document& all, const Document& other) {
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
  if (have_obj_labels(all, other)) {
    Document separated = other;
    separate_obj_labels(all, separated);
    return append_separated(all, separated);
  }
  return append_separated(all, other);
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
