// Grows a sphere radially by five steps of 0.02 and compares its volume with radius 1.1.
#include <transformesh/evolve.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 1000);
  const Velocity radial = [](const Mesh& now, const Progress&) {
    std::vector<Vec3> velocities;
    for (const Vec3& p : now.positions) velocities.push_back(0.02 * p.normalized());
    return velocities;
  };
  EvolveOptions options;
  options.iteration.remesh = RemeshOptions();
  const EvolveResult result = evolve(mesh, step_along(radial), options, {.iterations = 5});
  if (result.iterations != 5 || result.is_done || result.last.topology.genus != 0) return 1;
  if (std::abs(volume(mesh) - 4 * std::acos(-1.0) / 3 * 1.331) > 0.15) return 1;
  options.until = moved_less_than(1);
  return evolve(mesh, step_along(radial), options).is_done ? 0 : 1;
}
