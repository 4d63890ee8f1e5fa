// Makes targets of a mesh and of text with points, and rejects a closed mesh that is inside out.
#include <transformesh/shapes.h>
#include <transformesh/target.h>

using namespace transformesh;

int main() {
  const Mesh sphere = make_sphere(Vec3::Zero(), 1, 500);
  const Target target = make_target(sphere);
  if (!target.is_mesh() || !target.normals.empty()) return 1;
  if (target.mesh.faces.size() != sphere.faces.size()) return 1;
  if (!check_target(target, "sphere").empty()) return 1;
  const Target points = read_target("1 0 0 1 0 0\n0 1 0 0 1 0\n0 0 1 0 0 1\n", "points.txt");
  if (points.is_mesh() || points.normals.size() != 3 || points.has_estimated_normals) return 1;
  if (points.mesh.positions.size() != 3 || points.normals[1] != Vec3(0, 1, 0)) return 1;
  Mesh inside_out = sphere;
  for (Face& f : inside_out.faces) std::swap(f[0], f[1]);
  try {
    make_target(inside_out);
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
