/// Data about a part of a closed mesh with which the part can be cleaned alone, such that all
/// winding numbers are those of the whole mesh.
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
  /// Per welded face: 1 if the part contains all faces that meet the face, and all faces that meet
  /// any of these. Only faces with entry 1 (complete faces) are arranged.
  std::vector<char> is_complete;
  /// The part contains every face of the mesh that touches this box. The reference point is inside
  /// the box.
  Eigen::AlignedBox3d held;
  ReferencePoint reference;
  /// A grid, and its cells in which the part contains all faces (`covered`). They include all cells
  /// that faces with an `is_complete` entry of 1 touch.
  CellGrid grid{1};
  CellMarks covered;
};

}  // namespace transformesh
