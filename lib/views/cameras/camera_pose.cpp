#include "views/cameras/camera_pose.h"

#include <Eigen/LU>

#include "raster/camera_checks.h"

namespace transformesh {

std::string set_pose(const Eigen::Matrix3d& rotation, const Vec3& translation,
                     const std::string& who, PinholeCamera& camera) {
  // Tolerance of the product of the matrix with its transpose, because numbers in files may be
  // rounded to three digits.
  constexpr double rounding = 1e-3;
  const Eigen::Matrix3d error = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  if (!(error.cwiseAbs().maxCoeff() <= rounding))
    return "the rotation of " + who + " is not a rotation: its rows are not orthonormal";
  if (rotation.determinant() < 0)
    return "the rotation of " + who + " is a reflection: its determinant is -1";
  camera.rotation = rotation;
  camera.translation = translation;
  return translation_problem(translation, who);
}

std::string set_pose_at(const Eigen::Matrix3d& rotation, const Vec3& center, const std::string& who,
                        PinholeCamera& camera) {
  return set_pose(rotation, -(rotation * center), who, camera);
}

}  // namespace transformesh
