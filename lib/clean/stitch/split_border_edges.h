/// Splits border edges at border vertices within a tolerance, as at T-junctions, so that both sides
/// have the same vertices. No vertex moves or is added. The surface moves by the distance of the
/// vertices from the edges. Faces are cut into triangle fans; the new pieces follow all faces.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct BorderSplits {
  std::size_t edges = 0;
  std::vector<Index> face_source;  ///< for each new face the face that it is cut from
};

/// Splits the edges. Changes faces, but no columns. Vertices within the tolerance of each other
/// must already be joined.
BorderSplits split_border_edges(Mesh& mesh, double tolerance);

}  // namespace transformesh
