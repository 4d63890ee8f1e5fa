#include <array>

#include "io/document/losses.h"
#include "io/formats/column_groups.h"
#include "io/formats/vtk.h"
#include "io/formats/xyz.h"
#include "io/streams/text_buffer.h"
#include "support/counted.h"

namespace transformesh {
namespace {

/// Formats a row of text: numbers, separated by blanks, as text of floats or doubles.
class RowText {
 public:
  RowText(bool is_single, TextBuffer& text) : is_single_(is_single), text_(text) {}

  void add(double value, bool is_first) {
    if (!is_first) text_.add(' ');
    is_single_ ? text_.add_number(static_cast<float>(value)) : text_.add_number(value);
  }

 private:
  bool is_single_;
  TextBuffer& text_;
};

}  // namespace

WriteResult write_xyz(const Document& document) {
  const Mesh& mesh = document.mesh;
  const ColumnGroup normals = normal_group(mesh.vertex_columns);
  TextBuffer text;
  add_comments("#", document.style.comments, text);
  RowText coordinates(document.style.coordinate == Scalar::float32, text);
  RowText directions(!normals.empty() && normals[0]->type == Scalar::float32, text);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const Eigen::Index axis : {0, 1, 2}) coordinates.add(mesh.positions[v][axis], axis == 0);
    for (const Column* normal : normals) directions.add(normal->values[v], false);
    text.add('\n');
  }
  Keeps keeps{"XYZ", {}, {}};
  for (const Column* normal : normals) keeps.vertex_columns.push_back(normal->name);
  WriteResult result{unlike_vtk(text.take()), losses(document, keeps)};
  if (!mesh.faces.empty())
    result.notes.push_back("xyz: " + counted(mesh.faces.size(), "face") +
                           " cannot be stored in XYZ, dropped");
  return result;
}

}  // namespace transformesh
