/// The edges of an arrangement with the directions of the pieces along them. The order of the
/// pieces around an edge determines how to step from one face to another (paper 3.2.3, Fig. 5). A
/// halfedge is 3 * piece + corner.
#pragma once

#include <span>
#include <vector>

#include "clean/arrange/arrange.h"
#include "mesh/edges.h"

namespace transformesh {

/// The edges of the pieces for which included[piece] holds.
Edges piece_edges(const Arrangement& arrangement, const std::vector<char>& included);

/// The points that a halfedge connects.
Index halfedge_source(const std::vector<Piece>& pieces, Index halfedge);
Index halfedge_target(const std::vector<Piece>& pieces, Index halfedge);

/// Whether the halfedge goes from the smaller point or vertex to the larger.
bool is_forward(const std::vector<Piece>& pieces, Index halfedge);
inline bool is_forward(std::span<const Face> faces, Index halfedge) {
  return faces[halfedge / 3][halfedge % 3] < faces[halfedge / 3][(halfedge % 3 + 1) % 3];
}

/// The halfedges of one edge in counter-clockwise order as seen against the forward direction,
/// starting with the first. Exact. So a forward piece has its front towards its successor, and a
/// backward piece has its back there. Of coincident faces of a mesh the forward ones come first:
/// they then have their fronts towards each other, as bodies have that touch.
std::vector<Index> sort_around_edge(const Arrangement& arrangement,
                                    std::span<const Index> halfedges);
std::vector<Index> sort_around_edge(const Mesh& mesh, std::span<const Index> halfedges);

}  // namespace transformesh
