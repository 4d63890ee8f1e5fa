/// Facts about a closed mesh that a part of it needs to be cleaned alone, so that winding numbers
/// are those of the whole mesh.
#pragma once

#include <vector>

#include "geometry/search/cell_grid.h"

namespace transformesh {

/// A point off the surface, with its winding number in the whole mesh.
struct ReferencePoint {
  Vec3 position = Vec3::Zero();
  int winding = 0;
};

struct Surroundings {
  /// Per welded face: all faces that meet it, or that meet one of these, are in the part. Only such
  /// faces are arranged.
  std::vector<char> is_complete;
  /// The part has every face of the mesh that touches this box, and the reference point is in it.
  Eigen::AlignedBox3d held;
  ReferencePoint reference;
  /// The part has every face that touches a marked cell. Cells of complete faces are marked.
  CellGrid grid{1};
  CellMarks covered;
};

}  // namespace transformesh
