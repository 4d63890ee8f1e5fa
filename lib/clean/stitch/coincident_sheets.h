/// Separates coincident copies of a surface into layers. The result defines sheets: faces that are
/// connected across edges, with faces of equal corners treated as one bundle.
///
/// An edge of more than two faces still continues a surface if its faces are equally many copies of
/// two faces. Then each copy of one face gets a copy of the other face as neighbor. A copy with the
/// opposite direction along the edge is preferred, then the lowest face index. Hence copies that
/// were consistently oriented stay together. Faces of a copied one-sided surface get no neighbors.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "mesh/edges.h"

namespace transformesh {

/// Returns the neighbor of each halfedge across its edge, or no_index. At an edge of two faces this
/// is the result of neighbors_across(). At an edge of equally many copies of two faces it is the
/// halfedge of the copy in the same layer. `edges` must not contain faces that refer to a vertex
/// twice.
std::vector<Index> neighbors_in_layers(const Mesh& mesh, const Edges& edges);

}  // namespace transformesh
