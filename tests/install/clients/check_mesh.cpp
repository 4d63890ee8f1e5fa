// Checks that a sphere is its own outer boundary, and that a displaced sphere is not.
#include <transformesh/check_mesh.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh sphere = make_sphere(Vec3::Zero(), 1, 500);
  const Mesh displaced = make_sphere(Vec3(0.1, 0, 0), 1, 500);
  CheckMeshOptions options;
  options.certified = &sphere;
  const MeshCheck good = check_mesh(sphere, options);
  const MeshCheck bad = check_mesh(displaced, options);
  if (!good.problems.empty() || !good.certificate->input_is_closed) return 1;
  return bad.problems.size() == 1 && bad.certificate->wrong > 0 ? 0 : 1;
}
