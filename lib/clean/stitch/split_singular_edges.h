/// Splits singular edges in the middle, the last step of stitching (paper 3.3.2). Copies of the
/// ends do not separate a singular edge if the faces around both ends are connected in one
/// umbrella. The paper does not consider this case. Here each sheet gets its own vertex at the
/// midpoint of the edge, and its faces at the edge are cut in two. Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Result of the splits. Indices of faces are the indices before splitting.
struct EdgeSplits {
  struct Midpoint {
    Index face;                 ///< a face that contains the midpoint
    std::array<Index, 2> ends;  ///< ends of the edge; may be earlier midpoints
  };
  std::size_t edges = 0;           ///< number of split edges
  std::vector<Midpoint> vertices;  ///< new vertices
  std::vector<Index> face_source;  ///< for each new face the face that it is cut from
  std::vector<Index> cut_faces;    ///< faces that were cut; may contain duplicates
};

/// Splits the edges. Changes positions and faces, but no columns; new entries follow the old ones.
/// `opposite` holds for each halfedge the halfedge that continues its sheet, or no_index, and is
/// updated.
EdgeSplits split_singular_edges(Mesh& mesh, std::vector<Index>& opposite);

}  // namespace transformesh
