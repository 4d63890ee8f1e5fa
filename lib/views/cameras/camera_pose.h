/// Poses of cameras from the numbers of camera files.
#pragma once

#include <string>

#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// Sets rotation and translation of `camera`. `rotation` maps the world to the camera. Returns ""
/// if the pose is valid, else an error message, in which `who` is the name of the camera.
std::string set_pose(const Eigen::Matrix3d& rotation, const Vec3& translation,
                     const std::string& who, PinholeCamera& camera);
/// Does the same as set_pose(), with the camera's center instead of the translation.
std::string set_pose_at(const Eigen::Matrix3d& rotation, const Vec3& center, const std::string& who,
                        PinholeCamera& camera);

}  // namespace transformesh
