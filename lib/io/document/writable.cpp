#include "io/document/writable.h"

#include "io/document/finite_positions.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

void check_columns(const Columns& columns, std::size_t rows, const std::string& element) {
  for (const Column& column : columns.columns) {
    const bool fits = column.list_count_type
                          ? column.list_offsets.size() == rows + 1 &&
                                column.list_offsets.back() == column.values.size()
                          : column.values.size() == rows;
    if (fits) continue;
    std::string message = element + " property '" + column.name;
    throw GoalError(message.append("' does not have one value for each ").append(element));
  }
}

void check_finite(const Mesh& mesh) {
  if (are_finite(mesh.positions)) return;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].allFinite()) continue;
    throw GoalError("vertex " + std::to_string(i) +
                    " would have a coordinate that is not a finite number: no mesh is written");
  }
}

}  // namespace

void check_writable(const Document& document) {
  check_finite(document.mesh);
  check_columns(document.mesh.vertex_columns, document.mesh.positions.size(), "vertex");
  check_columns(document.mesh.face_columns, document.mesh.faces.size(), "face");
  for (const OtherElement& other : document.other_elements) {
    check_columns(other.columns, other.rows, other.name);
  }
}

}  // namespace transformesh
