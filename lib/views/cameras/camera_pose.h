/// Poses of cameras from the numbers of camera files.
#pragma once

#include <string>

#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// Sets rotation and translation of `camera`. `rotation` maps the world to the camera. Return what
/// is wrong with the pose of `who`, as a sentence; "" if nothing is.
std::string set_pose(const Eigen::Matrix3d& rotation, const Vec3& translation,
                     const std::string& who, PinholeCamera& camera);
/// Takes the camera's center instead of the translation.
std::string set_pose_at(const Eigen::Matrix3d& rotation, const Vec3& center, const std::string& who,
                        PinholeCamera& camera);

}  // namespace transformesh
