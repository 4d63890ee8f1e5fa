// Makes a torus and a sphere and compares their volumes, face counts and centers with closed forms.
#include <transformesh/shapes.h>

#include <algorithm>
#include <cmath>

using namespace transformesh;

int main() {
  const double pi = std::acos(-1.0);
  const Mesh torus = make_shape({.kind = "torus", .faces = 2000, .radius = 1, .tube = 0.3});
  if (std::abs(volume(torus) - 2 * pi * pi * 0.09) > 0.1) return 1;
  if (torus.positions.size() != torus.faces.size() / 2) return 1;
  const Mesh sphere = make_sphere(Vec3(1, 2, 3), 2, 500);
  if (sphere.faces.size() != 500 || std::abs(volume(sphere) - 32 * pi / 3) > 1) return 1;
  for (const Vec3& p : sphere.positions)
    if (std::abs((p - Vec3(1, 2, 3)).norm() - 2) > 1e-12) return 1;
  const std::vector<std::string>& kinds = shape_kinds();
  if (std::find(kinds.begin(), kinds.end(), "two-spheres") == kinds.end()) return 1;
  const double diagonal = shape_diagonal({.kind = "sphere", .radius = 2});
  if (std::abs(diagonal - std::sqrt(48)) > 0.3) return 1;
  try {
    make_shape({.kind = "box", .tube = 1});
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
