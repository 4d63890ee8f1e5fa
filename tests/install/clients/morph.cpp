// Morphs a sphere of radius 1 into one of radius 1.2 and compares the volume with the closed form.
#include <transformesh/morph.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Document document{.mesh = make_sphere(Vec3::Zero(), 1, 500)};
  const Target target = make_target(make_sphere(Vec3::Zero(), 1.2, 1000));
  const MorphResult result = morph(document, target, {}, {.iterations = 100});
  if (result.stop != MorphStop::converged || !result.fault.empty()) return 1;
  if (result.iterations == 0 || result.topology != Topology{1, 0}) return 1;
  if (!result.to_target || *result.to_target > 0.05) return 1;
  return std::abs(volume(document.mesh) - 4 * std::acos(-1.0) / 3 * 1.728) < 0.4 ? 0 : 1;
}
