// Compares a sphere of radius 1.1 with one of radius 1, which are 0.1 apart everywhere.
#include <transformesh/compare.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh large = make_sphere(Vec3::Zero(), 1.1, 2000);
  const Mesh small = make_sphere(Vec3::Zero(), 1, 2000);
  const Comparison result = compare(large, small, {.samples = 5000, .distance = 0.12});
  if (std::abs(result.mean - 0.1) > 0.01 || std::abs(result.rms - 0.1) > 0.01) return 1;
  if (std::abs(result.hausdorff - 0.1) > 0.02 || std::abs(result.accuracy - 0.1) > 0.01) return 1;
  if (result.completeness != 1) return 1;
  if (std::abs(result.volume_difference - 4 * std::acos(-1.0) / 3 * 0.331) > 0.03) return 1;
  for (const double distance : vertex_distances(large, small))
    if (std::abs(distance - 0.1) > 0.01) return 1;
  try {
    compare(Mesh(), small);
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
