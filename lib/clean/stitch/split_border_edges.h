/// Splits border edges at border vertices that lie within a tolerance of them, as at T-junctions,
/// so that both sides have the same vertices. No vertex moves or is added: the surface moves by the
/// distance of these vertices from their edges. Faces are cut into fans; pieces follow all faces.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct BorderSplits {
  std::size_t edges = 0;
  std::vector<Index> face_source;  ///< per new face: the face that it is cut from
};

/// Changes faces, but no columns. Pre: vertices within the tolerance of each other are joined.
BorderSplits split_border_edges(Mesh& mesh, double tolerance);

}  // namespace transformesh
