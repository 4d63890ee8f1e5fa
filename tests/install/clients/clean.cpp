// Cleans two overlapping spheres and compares the volume of the union with its closed form. Then
// cleans both halves of the space apart, and compares their area with that of the union.
#include <transformesh/clean.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

/// Area of the faces whose first vertex is on one side of the plane x = 0.5.
double area_of_side(const Mesh& mesh, double from, double to) {
  CleanOptions options;
  options.box = Box{Vec3(from, -9, -9), Vec3(to, 9, 9)};
  options.only = true;
  return surface_area(clean(mesh, options).mesh);
}

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
  const double area = area_of_side(mesh, -9, 0.5) + area_of_side(mesh, 0.5, 9);
  if (std::abs(area - surface_area(result.mesh)) > 1e-9) return 1;
  try {
    clean(mesh, {.refuse = true});
  } catch (const GoalError&) {
    return 0;
  }
  return 1;
}
