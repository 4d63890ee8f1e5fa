// Takes one step from a sphere of radius 1 to one of radius 1.01, which every vertex reaches.
#include <transformesh/morph_step.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 500);
  const Target target = make_target(make_sphere(Vec3::Zero(), 1.01, 2000));
  const MorphStepResult result = morph_step(mesh, target);
  if (result.distance != MorphDistance::surface) return 1;
  if (std::abs(result.to_target.rms - 0.01) > 0.004) return 1;
  if (result.displaced.moved != mesh.positions.size() || result.displaced.clamped != 0) return 1;
  for (const Vec3& p : mesh.positions)
    if (std::abs(p.norm() - 1.01) > 0.004) return 1;
  try {
    morph_step(mesh, make_target(Mesh{.positions = target.mesh.positions}),
               {.distance = MorphDistance::surface});
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
