/// The last step of stitching (paper 3.3.2): copies of its ends do not take a singular edge apart
/// where the faces around both ends hang together in one umbrella, which the paper does not
/// consider. There every sheet gets a vertex of its own in the middle of the edge, and its faces
/// there are cut in two. Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

/// What was split. Faces are named as they were before.
struct EdgeSplits {
  struct Midpoint {
    Index face;                 ///< a face that contains it
    std::array<Index, 2> ends;  ///< of the edge; they may be midpoints that come before it
  };
  std::size_t edges = 0;           ///< how many were split
  std::vector<Midpoint> vertices;  ///< the new ones
  std::vector<Index> face_source;  ///< per new face: the face that it is cut from
  std::vector<Index> cut_faces;    ///< faces that lost a part; some may be named twice
};

/// Changes positions and faces, but no columns; new ones follow the old. `opposite` says for every
/// halfedge which one continues its sheet, or no_index, and is kept up to date.
EdgeSplits split_singular_edges(Mesh& mesh, std::vector<Index>& opposite);

}  // namespace transformesh
