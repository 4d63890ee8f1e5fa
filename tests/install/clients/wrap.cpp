// Wraps points of a torus, with and without normals, and compares volumes with the closed form.
#include <transformesh/shapes.h>
#include <transformesh/wrap.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh torus = make_shape({.kind = "torus", .faces = 2000, .radius = 1, .tube = 0.4});
  const std::vector<Vec3>& points = torus.positions;
  std::vector<Vec3> normals;
  for (const Vec3& p : points) normals.push_back(p - Vec3(p.x(), p.y(), 0).normalized());
  const double expected = 2 * std::pow(std::acos(-1.0), 2) * 0.4 * 0.4;
  if (std::abs(volume(poisson_wrap(points, normals)) - expected) > 0.1 * expected) return 1;
  const AlphaWrap wrap = alpha_wrap(points, {.alpha = 0.2, .offset = 0.03});
  if (wrap.alpha != 0.2 || wrap.least_distance <= 0) return 1;
  const double larger = volume(wrap.mesh) / expected;
  if (larger < 1 || larger > 1.5) return 1;
  try {
    alpha_wrap({});
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
