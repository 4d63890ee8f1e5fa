// Selects components and faces of two separate spheres by size, box, column and point.
#include <transformesh/select.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh both = make_shape({.kind = "two-spheres", .faces = 1000, .gap = 0.2});
  Mesh one = both;
  const SelectionResult result = select(one, {.largest = 1});
  if (result.selected_faces + result.dropped_faces != both.faces.size()) return 1;
  if (connected_components(one).components.size() != 1 || result.dropped_faces == 0) return 1;
  Mesh around = both;
  const Vec3 inside = 0.5 * (bounding_box(one).min() + bounding_box(one).max());
  const SelectionResult found = select(around, {.around = inside});
  if (!found.contains_point || !*found.contains_point || around.faces != one.faces) return 1;
  Mesh marked = both;
  marked.face_columns.get("mark", Scalar::uint8, both.faces.size()).values[7] = 1;
  if (select(marked, {.where = "mark = 1"}).selected_faces != 1) return 1;
  try {
    select(marked, {.where = "mark > 1"});
  } catch (const GoalError&) {
    return marked.faces.size() == 1 ? 0 : 1;
  }
  return 1;
}
