/// Sets poses of cameras to numbers that were read from camera files, if they are valid.
#pragma once

#include <string>

#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// Sets rotation and translation of `camera`. They map world coordinates to camera coordinates.
/// Returns "" if the pose is valid, else an error message, in which `who` is the name of the
/// camera.
std::string set_pose(const Eigen::Matrix3d& rotation, const Vec3& translation,
                     const std::string& who, PinholeCamera& camera);
/// Does the same as set_pose(), but gets the camera's center instead of the translation.
std::string set_pose_at(const Eigen::Matrix3d& rotation, const Vec3& center, const std::string& who,
                        PinholeCamera& camera);

}  // namespace transformesh
