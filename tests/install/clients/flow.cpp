// Checks a flow in closed form, one by curvature, and one of a grid.
#include <transformesh/flow.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh mesh = make_sphere(Vec3::Zero(), 2, 1000);
  const Motion expansion = make_flow("expansion", {.speed = 3, .center = Vec3(1, 0, 0)}).motion;
  const Motion curvature = make_flow("mean-curvature").motion;
  const std::vector<Vec3> grown = expansion.velocity(mesh, {}, Progress());
  const std::vector<Vec3> shrunk = curvature.displacement(mesh, {.span = 0.1}, Progress());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if ((grown[v] - 3 * (p - Vec3(1, 0, 0))).norm() > 1e-12) return 1;
    // The semi-implicit radius is 2 / (1 + 2 * 0.1 / 4).
    if (((p + shrunk[v]).norm() - 2 / 1.05) > 0.01) return 1;
  }
  FlowGrid grid;
  grid.values = {1, 2, 3};
  const Flow wind = make_flow("grid", {.grids = {grid}});
  if (wind.motion.velocity(mesh, {}, Progress())[5] != Vec3(1, 2, 3)) return 1;
  if (wind.counts->outside != 0 || flow_kinds().empty()) return 1;
  try {
    read_flow_grid("nothing", "a.vti", 3);
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
