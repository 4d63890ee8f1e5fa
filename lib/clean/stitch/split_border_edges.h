/// Splits border edges at other border vertices that are within a tolerance of them, as at
/// T-junctions. Afterwards both sides of a gap have the same vertices. No vertex moves or is added.
/// The surface moves by at most the distance of these vertices from the edges. Each face is cut
/// into a triangle fan; its first triangle replaces the face, and the others follow all faces.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct BorderSplits {
  std::size_t edges = 0;
  std::vector<Index> face_source;  ///< for each new face the face that it is cut from
};

/// Splits border edges at vertices within the tolerance. Changes faces, but no columns. Vertices
/// within the tolerance of each other must already be joined.
BorderSplits split_border_edges(Mesh& mesh, double tolerance);

}  // namespace transformesh
