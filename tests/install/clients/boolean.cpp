// Cuts a cube out of another one, and a sheet by both.
#include <transformesh/boolean.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh box = make_shape({.kind = "box", .parameters = {"2", "2", "2"}, .faces = 12});
  Mesh corner = box;
  for (Vec3& p : corner.positions) p += Vec3(1, 1, 1);
  const BooleanResult cut =
      boolean(BooleanOperation::subtract, {{&box, "box"}, {&corner, "corner"}});
  if (std::abs(connected_components(cut.mesh).components[0].volume - 7) > 1e-12) return 1;
  if (!cut.inside_out.empty()) return 1;
  const BooleanResult inside = cut_sheet({&corner, "corner"}, {&box, "box"}, SheetSide::inside);
  const Components parts = connected_components(inside.mesh);
  return parts.components.size() == 1 && parts.components[0].boundary_loops == 1 ? 0 : 1;
}
