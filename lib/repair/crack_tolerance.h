/// Measures cracks: borders that nearly meet because coordinates were rounded or computed twice.
/// Cost: O(n log n). Deterministic.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

struct Cracks {
  double width = 0;           ///< largest distance of a vertex from the other side; 0: no crack
  double tolerance = 0;       ///< joins the sides (StitchOptions::tolerance); 0: no crack
  std::size_t vertices = 0;   ///< border vertices at cracks
  Vec3 place = Vec3::Zero();  ///< the widest
};

/// Finds the cracks of a mesh. Compares the distances of border vertices from their nearest others
/// with the lengths of edges. Cracks exist if there is a clear gap between the two, and if the
/// faces on both sides continue each other, unlike the two sides of a thin plate.
Cracks find_cracks(const Mesh& mesh);

}  // namespace transformesh
