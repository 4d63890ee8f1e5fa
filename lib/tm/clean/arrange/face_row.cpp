#include "tm/clean/arrange/face_row.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace transformesh {

RowBlend row_on_face(const Mesh& mesh, Index face, const Vec3& position) {
  const Face& f = mesh.faces[face];
  const Vec3 &a = mesh.positions[f[0]], &b = mesh.positions[f[1]], &c = mesh.positions[f[2]];
  const Vec3 normal = (b - a).cross(c - a);
  const double total = normal.squaredNorm();
  std::array<double, 3> weight{1, 0, 0};
  if (total > 0) {
    weight[1] = std::clamp(normal.dot((position - a).cross(c - a)) / total, 0.0, 1.0);
    weight[2] = std::clamp(normal.dot((b - a).cross(position - a)) / total, 0.0, 1.0 - weight[1]);
    weight[0] = 1 - weight[1] - weight[2];
  }
  return {f, weight};
}

}  // namespace transformesh
