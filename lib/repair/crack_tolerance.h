/// Measures cracks: borders that nearly meet because coordinates were rounded or computed twice.
/// Cost: O(n log n). Deterministic.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

struct Cracks {
  /// Largest distance of a border vertex from the other side of its crack; 0 if there is no crack.
  double width = 0;
  /// StitchOptions::tolerance that closes the cracks; 0 if there is no crack.
  double tolerance = 0;
  std::size_t vertices = 0;   ///< number of border vertices at cracks
  Vec3 place = Vec3::Zero();  ///< border vertex at the widest place
};

/// Finds the cracks of a mesh. Compares the distances between border vertices and border edges with
/// the lengths of all edges. Cracks exist under two conditions: their widths are clearly smaller
/// than almost all other lengths, and the faces on their two sides continue each other. The faces
/// at the rim of a thin plate without rim faces fold back instead.
Cracks find_cracks(const Mesh& mesh);

}  // namespace transformesh
