/// Reads the sparse points that were reconstructed together with the cameras of a file.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the points of COLMAP's model that are in the same folder as its cameras, except for
/// doubtful points (doubtful_points.h). `cameras` is a file or folder, as for cameras_from().
/// Returns nothing if the folder has no file of points. Throws as read_colmap_points() does.
std::vector<Vec3> sparse_points_beside(const std::string& cameras);

}  // namespace transformesh
