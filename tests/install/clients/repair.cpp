// Makes a solid of a box without a face.
#include <transformesh/repair.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh box = make_shape({.kind = "box", .parameters = {"1", "2", "3"}, .faces = 12});
  box.faces.pop_back();
  const RepairResult result = repair(box);
  const Components parts = connected_components(result.mesh);
  if (result.steps.empty() || parts.components.size() != 1) return 1;
  return std::abs(parts.components[0].volume - 6) < 1e-12 ? 0 : 1;
}
