// Finds that a result of two components with the connectivity of one sphere disagrees with itself.
#include <transformesh/clean_result.h>
#include <transformesh/shapes.h>

using namespace transformesh;

bool agrees(const CleanResult& result) {
  if (!result.connectivity) return result.changed;
  return connected_components(result.mesh).components.size() == result.connectivity->components;
}

int main() {
  CleanResult result;
  if (agrees(result) || result.least_margin != 0.5) return 1;
  result.mesh = make_sphere(Vec3::Zero(), 1, 500);
  result.connectivity.emplace();
  result.connectivity->components = 1;
  if (!agrees(result)) return 1;
  result.connectivity->components = 2;
  return agrees(result) ? 1 : 0;
}
