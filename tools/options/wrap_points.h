/// The points that tm-wrap wraps.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"

namespace transformesh::tool {

struct Points {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< normals of all points, or empty
};

/// Reads points of any mesh format, or of COLMAP.
Mesh read_cloud(const std::string& path, const std::string& name, Run& run);

/// Returns the points of a cloud, without probable outliers unless `keeps_outliers` is set. Returns
/// all vertices of a mesh with faces. States on stderr and in the report which points are left out.
Points points_of(const Mesh& cloud, bool keeps_outliers, Run& run);

/// Prints a note if the wrap most likely follows stray points instead of the object.
void note_absurd(const Mesh& mesh, std::size_t points, Run& run);

}  // namespace transformesh::tool
