#include "tm/io/losses.h"
#include "tm/io/obj.h"
#include "tm/io/scalar.h"
#include "tm/io/text_buffer.h"

namespace transformesh {
namespace {

std::vector<const Column*> color_columns(const Columns& columns) {
  if (!has_columns(columns, {"red", "green", "blue"})) return {};
  return {columns.find("red"), columns.find("green"), columns.find("blue")};
}

void add_vertices(const Mesh& mesh, TextBuffer& text) {
  const std::vector<const Column*> colors = color_columns(mesh.vertex_columns);
  for (std::size_t row = 0; row < mesh.positions.size(); ++row) {
    text.add('v');
    for (const Eigen::Index axis : {0, 1, 2}) {
      text.add(' ');
      text.add_number(mesh.positions[row][axis]);
    }
    for (const Column* column : colors) {
      text.add(' ');
      text.add_number(column->values[row] / (is_floating(column->type) ? 1 : 255));
    }
    text.add('\n');
  }
}

void add_faces(const Mesh& mesh, TextBuffer& text) {
  for (const Face& face : mesh.faces) {
    text.add('f');
    for (const Index corner : face) {
      text.add(' ');
      text.add_number(std::uint64_t{corner} + 1);
    }
    text.add('\n');
  }
}

}  // namespace

WriteResult write_obj(const Document& document) {
  TextBuffer text;
  add_comments("#", document.style.comments, text);
  if (document.mesh.positions.empty()) text.add("o empty\n");  // else the format could not be told
  add_vertices(document.mesh, text);
  add_faces(document.mesh, text);
  Keeps keeps{"OBJ", {}, {}};
  if (!color_columns(document.mesh.vertex_columns).empty()) {
    keeps.vertex_columns = {"red", "green", "blue"};
  }
  return {text.take(), losses(document, keeps)};
}

}  // namespace transformesh
