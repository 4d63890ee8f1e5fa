/// The sparse points that belong to a camera file.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the points of COLMAP's model beside its cameras, without doubtful ones
/// (doubtful_points.h). `cameras` is a place as for cameras_from(). Returns nothing if there is no
/// such file. Throws as read_colmap_points().
std::vector<Vec3> sparse_points_beside(const std::string& cameras);

}  // namespace transformesh
