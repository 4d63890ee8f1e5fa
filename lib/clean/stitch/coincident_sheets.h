/// Separates coincident copies of a surface into layers. All faces with the same three corners form
/// a bundle. Neighboring bundles of equally many faces are connected layer by layer, so that each
/// copy of the surface becomes a separate sheet of connected faces.
///
/// At an edge of more than two faces, layers are connected if the faces belong to two bundles of
/// equally many faces. Then each face of one bundle gets a face of the other bundle as neighbor.
/// Faces that traverse the edge in opposite directions are preferred, then low face indices. Hence
/// copies that were consistently oriented stay together. Copies of a one-sided surface, such as a
/// Moebius strip, get no neighbors at these edges. Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "mesh/edges.h"

namespace transformesh {

/// Returns the opposite of each halfedge, or no_index. At an edge of two faces this is the result
/// of neighbors_across(). At an edge where two sets of n coincident faces meet, a halfedge gets the
/// halfedge of the face in the same layer. `edges` must not contain faces that refer to a vertex
/// twice.
std::vector<Index> neighbors_in_layers(const Mesh& mesh, const Edges& edges);

}  // namespace transformesh
