/// The points that tm-wrap wraps.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"

namespace transformesh::tool {

struct Points {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< none, or of all
};

/// Reads points of any mesh format, or of COLMAP.
Mesh read_cloud(const std::string& path, const std::string& name, Run& run);

/// Returns the points of a cloud without those that are doubtful, unless `keeps_outliers`; of a
/// mesh, all vertices. Names what is left out on stderr and in the report.
Points points_of(const Mesh& cloud, bool keeps_outliers, Run& run);

/// Notes a wrap that most likely follows stray points instead of the object.
void note_absurd(const Mesh& mesh, std::size_t points, Run& run);

}  // namespace transformesh::tool
