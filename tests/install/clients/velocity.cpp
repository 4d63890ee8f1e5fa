// Checks normal and curvature velocities of a sphere of radius 2 and velocities from columns.
#include <transformesh/shapes.h>
#include <transformesh/velocity.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 2, 1000);
  const std::size_t rows = mesh.positions.size();
  const std::vector<Vec3> normal = normal_velocities(mesh, 3), flow = curvature_velocities(mesh, 3);
  const std::vector<double> curvatures = mean_curvatures(mesh);
  for (std::size_t v = 0; v < rows; ++v) {
    const Vec3 outwards = mesh.positions[v] / 2;
    if ((normal[v] - 3 * outwards).norm() > 0.1) return 1;
    if ((flow[v] + 3 * 0.5 * outwards).norm() > 0.1) return 1;
    if (std::abs(curvatures[v] - 0.5) > 0.03) return 1;
  }
  if (has_column_velocities(mesh)) return 1;
  for (const char* name : {"vx", "vy", "vz"})
    mesh.vertex_columns.get(name, Scalar::float64, rows).values.assign(rows, 2);
  mesh.vertex_columns.get("mask", Scalar::float64, rows).values[0] = 0.5;
  std::vector<Vec3> velocities = column_velocities(mesh);
  if (velocities[0] != Vec3(2, 2, 2)) return 1;
  apply_mask(mesh, "mask", velocities);
  return velocities[0] == Vec3(1, 1, 1) && velocities[1] == Vec3::Zero() ? 0 : 1;
}
