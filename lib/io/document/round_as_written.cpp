#include "io/document/round_as_written.h"

#include "io/document/scalar.h"
#include "io/document/writable.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

void round_columns(Columns& columns) {
  for (Column& column : columns.columns) {
    if (column.type == Scalar::float64) continue;
    with_scalar(column.type, [&](auto zero) {
      for (double& value : column.values) {
        const volatile auto written = to_scalar<decltype(zero)>(value);  // see round_to_single()
        value = static_cast<double>(written);
      }
    });
  }
}

}  // namespace

std::size_t round_positions(Mesh& mesh, Scalar coordinate) {
  if (coordinate != Scalar::float32) return 0;
  check_float_range(mesh);
  const std::vector<Vec3> before = mesh.positions;
  for (Vec3& position : mesh.positions) {
    for (double& x : position) x = round_to_single(x);
  }
  const RoundingLoss loss = rounding_loss(mesh, before);
  if (2 * (loss.collapsed + loss.turned) > mesh.faces.size()) {
    throw GoalError(
        "float is too coarse for this mesh: most of its faces would collapse or turn over; write "
        "double, in PLY, OFF or OBJ, or move the mesh to the origin first");
  }
  return loss.collapsed;
}

void round_as_written(Document& document) {
  check_writable(document);
  if (document.style.coordinate == Scalar::float32) {
    check_float_range(document.mesh);
    for (Vec3& position : document.mesh.positions) position = position.unaryExpr(&round_to_single);
  }
  round_columns(document.mesh.vertex_columns);
  round_columns(document.mesh.face_columns);
  for (OtherElement& other : document.other_elements) round_columns(other.columns);
}

}  // namespace transformesh
