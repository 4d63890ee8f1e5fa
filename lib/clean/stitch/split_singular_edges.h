/// Splits singular edges (edges of more than two faces) in the middle. This is the last step of
/// stitching (paper 3.3.2). Before, stitching duplicates the ends of singular edges, so that each
/// sheet gets its own vertices. This does not help if the sheets are connected around both ends.
/// The paper does not consider this case. Here each sheet gets its own vertex at the midpoint of
/// the edge, and the faces of the sheet at the edge are cut in two. Cost: O(n log n).
/// Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Result of split_singular_edges(). Face indices in it are those before splitting.
struct EdgeSplits {
  struct Midpoint {
    Index face;                 ///< a face that contains the edge
    std::array<Index, 2> ends;  ///< ends of the split edge; may be midpoints that were added before
  };
  std::size_t edges = 0;           ///< number of split edges
  std::vector<Midpoint> vertices;  ///< one entry for each new vertex
  std::vector<Index> face_source;  ///< for each new face the face that it is cut from
  std::vector<Index> cut_faces;    ///< faces that were cut; may contain duplicates
};

/// Splits all edges of more than two faces at their midpoints. Changes positions and faces, but no
/// columns. New vertices and faces follow the old ones. `opposite` holds for each halfedge the
/// halfedge of the next face in the same sheet, or no_index; it is updated.
EdgeSplits split_singular_edges(Mesh& mesh, std::vector<Index>& opposite);

}  // namespace transformesh
