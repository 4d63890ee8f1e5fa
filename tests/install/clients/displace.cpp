// Displaces the vertices of a sphere radially by 0.01 and checks the radius and the clamp.
#include <transformesh/displace.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 500);
  const std::vector<Vec3> velocities = mesh.positions;
  const DisplaceResult result = displace(mesh, velocities, {.time_step = 0.01});
  if (result.moved != mesh.positions.size() || result.clamped != 0) return 1;
  for (const Vec3& p : mesh.positions)
    if (std::abs(p.norm() - 1.01) > 1e-9) return 1;
  const DisplaceResult clamped = displace(mesh, velocities, {.time_step = 100, .alpha = 0.1});
  if (clamped.clamped != mesh.positions.size()) return 1;
  if (clamped.max_displacement > 0.2 * clamped.mean_edge) return 1;
  try {
    displace(mesh, std::span(velocities).first(3));
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
