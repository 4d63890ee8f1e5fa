/// Copies of a surface that lie upon each other, distinguished: as the sheets that hang together
/// across edges, faces with the same corners counting as one.
///
/// An edge of more than two faces still continues a surface if they are copies of two faces, as
/// many of each. Then each copy of the one gets a copy of the other as its neighbor: one that runs
/// the opposite way along the edge while there is one, and of these the lowest, so that copies that
/// agreed stay together. Faces of a copied surface with one side only get no neighbors there.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "mesh/edges.h"

namespace transformesh {

/// For every halfedge the one across its edge: as neighbors_across() says where the edge has two,
/// and that of the neighboring copy where it has copies of two faces; else no_index. `edges` leave
/// out faces that name a vertex twice.
std::vector<Index> neighbors_in_layers(const Mesh& mesh, const Edges& edges);

}  // namespace transformesh
