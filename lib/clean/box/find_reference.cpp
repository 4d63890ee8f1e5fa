#include "clean/box/find_reference.h"

#include "geometry/axis_path.h"
#include "mesh/location_text.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Number of points that are tried. A point is rejected if the path to it touches an edge. This
/// happens only by coincidence, or if the box is only a few coordinate spacings wide. Twice as many
/// attempts would find no more points; with only four attempts, failures would be noticeable.
constexpr int most_attempts = 64;

}  // namespace

ReferencePoint find_reference(const Mesh& mesh, const ReferencePoint& known, const Box& box) {
  for (int i = 0; i < most_attempts; ++i) {
    const Vec3 point = spread_point(box, i);
    AxisPath path(known.position, point);
    for (Index f = 0; f < mesh.faces.size(); ++f) path.add(triangle_of(mesh, f));
    if (const std::optional<int> change = path.change()) return {point, known.winding + *change};
  }
  throw GoalError("no point with a known winding number is found between " + point_text(box.min()) +
                  " and " + point_text(box.max()));
}

}  // namespace transformesh
