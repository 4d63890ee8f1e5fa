/// The edges of an arrangement: which way the pieces run along them, and the order of the pieces
/// around them. A halfedge is 3 * piece + corner.
#pragma once

#include <span>
#include <vector>

#include "tm/clean/arrange/arrange.h"
#include "tm/mesh/edges.h"

namespace transformesh {

/// The edges of the pieces for which included[piece] holds.
Edges piece_edges(const Arrangement& arrangement, const std::vector<char>& included);

/// The points that a halfedge connects.
Index halfedge_source(const std::vector<Piece>& pieces, Index halfedge);
Index halfedge_target(const std::vector<Piece>& pieces, Index halfedge);

/// Whether the halfedge runs from the smaller point index to the larger.
bool is_forward(const std::vector<Piece>& pieces, Index halfedge);

/// The halfedges of one edge in counter-clockwise order as seen against the forward direction,
/// starting with the first. Exact. So a forward piece has its front towards its successor and a
/// backward piece has its back there. Where faces of a mesh coincide, forward ones come first, so
/// that nothing but emptiness lies between them.
std::vector<Index> sort_around_edge(const Arrangement& arrangement,
                                    std::span<const Index> halfedges);
std::vector<Index> sort_around_edge(const Mesh& mesh, std::span<const Index> halfedges);

}  // namespace transformesh
