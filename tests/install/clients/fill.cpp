// Fills the hole at the top of a sphere and compares the volume with the closed form.
#include <transformesh/fill.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 500);
  std::vector<Face> kept;
  for (const Face& f : mesh.faces) {
    const Vec3 middle = (mesh.positions[f[0]] + mesh.positions[f[1]] + mesh.positions[f[2]]) / 3;
    if (middle.z() < 0.8) kept.push_back(f);
  }
  if (kept.size() == mesh.faces.size()) return 1;
  mesh.faces = kept;
  Mesh limited = mesh;
  const FillResult none = fill_holes(limited, {.max_edges = 3});
  if (none.filled() != 0 || none.too_large.size() != 1) return 1;
  const FillResult result = fill_holes(mesh);
  if (result.holes != 1 || result.filled() != 1 || result.new_faces == 0) return 1;
  if (mesh.faces.size() != kept.size() + result.new_faces) return 1;
  return std::abs(volume(mesh) - 4 * std::acos(-1.0) / 3) < 0.15 ? 0 : 1;
}
