// Cleans the two halves of two overlapping spheres and checks that both together are the cleaned
// whole.
#include <transformesh/clean.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh mesh = make_shape({.kind = "two-spheres", .faces = 1000});
  const Box all = bounding_box(mesh);
  Box left = all, right = all;
  left.minimum.array() -= 1;
  right.minimum.array() -= 1;
  left.maximum.array() += 1;
  right.maximum.array() += 1;
  left.maximum.x() = right.minimum.x() = 0.5 * (all.minimum.x() + all.maximum.x());
  const CleanResult a = clean(mesh, {.box = left, .only = true});
  const CleanResult b = clean(mesh, {.box = right, .only = true});
  if (a.box_faces + b.box_faces != mesh.faces.size() || !a.changed) return 1;
  const Mesh whole = clean(mesh).mesh;
  if (a.mesh.faces.size() + b.mesh.faces.size() != whole.faces.size()) return 1;
  const double area = surface_area(a.mesh) + surface_area(b.mesh);
  if (std::abs(area - surface_area(whole)) > 1e-9) return 1;
  return area < surface_area(mesh) - 0.1 ? 0 : 1;
}
