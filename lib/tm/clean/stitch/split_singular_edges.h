/// The last step of stitching (paper 3.3): copies of its ends do not take a singular edge apart
/// where the faces around both ends hang together in one fan. There every sheet gets a vertex of
/// its own in the middle of the edge, and its faces there are cut in two. Cost: O(n log n).
/// Deterministic.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// Faces named are those before the call.
struct EdgeSplits {
  struct Middle {
    Index face;                 ///< on whose edge it is, or in which
    std::array<Index, 2> ends;  ///< of the edge; new vertices only where they come before
  };
  std::size_t edges = 0;           ///< that were split
  std::vector<Middle> vertices;    ///< the new ones
  std::vector<Index> face_source;  ///< per new face: the face that it is cut from
  std::vector<Index> cut_faces;    ///< faces that lost a part; may repeat
};

/// Changes positions and faces alone; new ones follow the old. `opposite` says for every halfedge
/// which one continues its sheet, or no_index, and is kept up to date.
EdgeSplits split_singular_edges(Mesh& mesh, std::vector<Index>& opposite);

}  // namespace transformesh
