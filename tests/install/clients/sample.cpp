// Samples a unit sphere by area and as a Poisson disk and checks counts, places and distances.
#include <transformesh/sample.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh sphere = make_sphere(Vec3::Zero(), 1, 1000);
  const Mesh points = sample_surface(sphere, {.count = 300});
  if (points.positions.size() != 300 || !points.faces.empty()) return 1;
  const Column* nx = points.vertex_columns.find("nx");
  if (!nx) return 1;
  for (std::size_t v = 0; v < 300; ++v)
    if (std::abs(nx->values[v] - points.positions[v].x()) > 0.1) return 1;
  const std::vector<Vec3> disk = sample_surface(sphere, {.distance = 0.3}).positions;
  if (disk.size() < 80 || disk.size() > 160) return 1;
  for (std::size_t a = 0; a < disk.size(); ++a) {
    if (disk[a].norm() < 0.98 || disk[a].norm() > 1 + 1e-9) return 1;
    for (std::size_t b = 0; b < a; ++b)
      if ((disk[a] - disk[b]).norm() < 0.3 - 1e-9) return 1;
  }
  try {
    sample_surface(sphere, {});
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
