#include "io/document/round_as_written.h"

#include "io/document/scalar.h"
#include "io/document/writable.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh {
namespace {

void round_columns(Columns& columns) {
  for (Column& column : columns.columns) {
    if (column.type == Scalar::float64) continue;
    with_scalar(column.type, [&](auto zero) {
      for (double& value : column.values) {
        // The variable is volatile for the reason that the comment of round_to_single() gives.
        const volatile auto written = to_scalar<decltype(zero)>(value);
        value = static_cast<double>(written);
      }
    });
  }
}

}  // namespace

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
