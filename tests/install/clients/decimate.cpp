// Decimates a sphere to 500 faces and compares its volume with the closed form.
#include <transformesh/decimate.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 2000);
  const std::size_t faces = mesh.faces.size();
  const DecimateResult result = decimate(mesh, {.faces = 500});
  if (mesh.faces.size() != result.faces || result.faces > 500 || result.faces < 499) return 1;
  if (result.collapses == 0 || faces <= 500) return 1;
  if (std::abs(volume(mesh) - 4 * std::acos(-1.0) / 3) > 0.1) return 1;
  try {
    decimate(mesh, {.faces = 3});
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
