// Checks a sphere, a sphere without one face and a sphere with one reversed face.
#include <transformesh/manifold.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh sphere = make_sphere(Vec3::Zero(), 1, 500);
  const ManifoldReport good = check_manifold(sphere);
  if (!good.is_manifold() || !good.is_oriented() || !good.is_closed()) return 1;
  if (!manifold_problem(sphere, good, true).sentence.empty()) return 1;
  Mesh open = sphere;
  open.faces.pop_back();
  const ManifoldReport with_border = check_manifold(open);
  if (with_border.border_halfedges.size() != 3 || with_border.boundary_loops != 1) return 1;
  if (!manifold_problem(open, with_border, false).sentence.empty()) return 1;
  if (manifold_problem(open, with_border, true).sentence.empty()) return 1;
  Mesh reversed = sphere;
  std::swap(reversed.faces[0][0], reversed.faces[0][1]);
  const ManifoldReport misoriented = check_manifold(reversed);
  return misoriented.misoriented_edges.size() == 3 && !misoriented.is_oriented() ? 0 : 1;
}
