// Cleans two overlapping spheres and compares the volume of the union with its closed form.
#include <transformesh/clean.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 1000);
  const Mesh second = make_sphere(Vec3(1, 0, 0), 1, 1000);
  const auto first_vertex = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), second.positions.begin(), second.positions.end());
  for (const Face& f : second.faces)
    mesh.faces.push_back({f[0] + first_vertex, f[1] + first_vertex, f[2] + first_vertex});
  const CleanResult result = clean(mesh);
  const double ball = 4 * std::acos(-1.0) / 3, lens = 5 * std::acos(-1.0) / 12;
  const Components parts = connected_components(result.mesh);
  if (!result.changed || result.pairs == 0 || parts.components.size() != 1) return 1;
  if (parts.genus() != 0 || parts.components[0].boundary_loops != 0) return 1;
  if (std::abs(parts.components[0].volume - (2 * ball - lens)) > 0.1) return 1;
  try {
    clean(mesh, {.refuse = true});
  } catch (const GoalError&) {
    return 0;
  }
  return 1;
}
