// Scales, mirrors, rotates and centers a torus and compares its volume and box with closed forms.
#include <transformesh/shapes.h>
#include <transformesh/transform.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_shape({.kind = "torus", .faces = 1000, .center = Vec3(5, 0, 0)});
  const double before = volume(mesh);
  const Matrix4 matrix = mirroring_in(Vec3(1, 0, 0), 0) * scaling_by(Vec3(2, 2, 2));
  const TransformResult result = transform(mesh, matrix);
  if (!result.is_mirror || std::abs(result.scale - 2) > 1e-12) return 1;
  if (std::abs(volume(mesh) - 8 * before) > 1e-9) return 1;
  const Matrix4 quarter = rotation_about(Vec3(0, 0, 1), 90);
  if ((quarter * Eigen::Vector4d(1, 0, 0, 1)) != Eigen::Vector4d(0, 1, 0, 1)) return 1;
  const Box mapped = mapped_box(mesh, fitting_unit_box(bounding_box(mesh)));
  transform(mesh, fitting_unit_box(bounding_box(mesh)));
  const Box box = bounding_box(mesh);
  if ((box.max() - mapped.max()).norm() > 1e-12) return 1;
  if (std::abs((box.max() - box.min()).maxCoeff() - 1) > 1e-12) return 1;
  try {
    transform(mesh, Matrix4::Zero());
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
