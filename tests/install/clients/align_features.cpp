// Projects a sphere radially onto a cube and aligns its vertices with the edges of the cube.
#include <transformesh/align_features.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh cube = make_shape({.kind = "box", .parameters = {"2", "2", "2"}, .faces = 12});
  if (cube.faces.size() != 12 || std::abs(volume(cube) - 8) > 1e-9 || !has_features(cube)) return 1;
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 1280);
  for (Vec3& p : mesh.positions) p /= p.cwiseAbs().maxCoeff();
  const double lacking = 8 - volume(mesh);
  const AlignResult result = align_features(mesh, cube, {.min_edge = 0.05, .max_edge = 0.2});
  if (result.sharp_edges != 12 || result.corners != 8 || result.aligned < 8) return 1;
  return 8 - volume(mesh) < 0.1 * lacking ? 0 : 1;
}
