// Measures a unit sphere of 2000 faces and compares the values with closed forms.
#include <transformesh/measure.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh mesh = make_sphere(Vec3::Zero(), 1, 2000);
  const double pi = std::acos(-1.0);
  if (std::abs(volume(mesh) - 4 * pi / 3) > 0.05) return 1;
  if (std::abs(surface_area(mesh) - 4 * pi) > 0.1) return 1;
  if (std::abs(face_normal(mesh, 0).norm() - 2 * face_area(mesh, 0)) > 1e-12) return 1;
  const EdgeLengths edges = edge_lengths(mesh);
  if (edges.count != mesh.faces.size() * 3 / 2 || edges.minimum > edges.mean) return 1;
  if (edges.mean > edges.maximum || edges.minimum <= 0) return 1;
  if (angles(mesh).minimum_deg < 40 || angles(mesh).minimum_mean_deg > 60) return 1;
  if (valence_six_share(mesh) < 0.98 || valence_six_share(mesh) >= 1) return 1;
  const std::vector<Vec3> normals = vertex_normals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v)
    if ((normals[v] - mesh.positions[v]).norm() > 0.02) return 1;
  return std::abs(diagonal_of(bounding_box(mesh)) - std::sqrt(12)) < 0.05 ? 0 : 1;
}
