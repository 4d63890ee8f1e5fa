// Moves a sphere by a constant velocity for two units of time and checks its volume and place.
#include <transformesh/evolve_in_time.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 1000);
  const double before = volume(mesh);
  const Motion rising{[](const Mesh& now, const Moment&, const Progress&) {
    return std::vector<Vec3>(now.positions.size(), Vec3(0, 0, 0.5));
  }};
  EvolveOptions options;
  options.iteration.remesh.smoothing = Smoothing::none;
  const TimeResult result = evolve_in_time(mesh, rising, {.end = 2, .keep_volume = true}, options);
  if (!result.evolution.is_done || result.time != 2) return 1;
  if (result.evolution.last.topology != Topology{1, 0}) return 1;
  if (std::abs(volume(mesh) - before) > 1e-10 * before) return 1;
  const Box box = bounding_box(mesh);
  return std::abs(box.min().z() + box.max().z() - 2) < 0.02 ? 0 : 1;
}
