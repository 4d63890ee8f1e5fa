#include "shapes/assembly.h"

#include <Eigen/Geometry>

#include "support/random.h"

namespace transformesh::shapes {

Eigen::Matrix3d generic_rotation(unsigned index) {
  Random random(index);
  Eigen::Quaterniond rotation;
  do {
    for (double& component : rotation.coeffs()) component = random.uniform(-1, 1);
  } while (rotation.squaredNorm() > 1 || rotation.squaredNorm() < 0.1);
  return rotation.normalized().toRotationMatrix();
}

void transform(Mesh& mesh, const Eigen::Matrix3d& linear, const Vec3& offset) {
  for (Vec3& point : mesh.positions) point = (linear * point + offset).eval();
}

void append(Mesh& mesh, const Mesh& part) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const Face& face : part.faces)
    mesh.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
}

}  // namespace transformesh::shapes
