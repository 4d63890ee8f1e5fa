/// Sorts the faces at an edge, or the pieces (triangles of cut faces), by their angle around the
/// edge. This angular order determines the next face when crossing an edge (paper 3.2.3, Fig. 5). A
/// halfedge is 3 * piece + corner. Cost: O(k log k) for k halfedges at an edge. Exact.
#pragma once

#include <span>
#include <vector>

#include "clean/arrange/arrange.h"
#include "mesh/edges.h"

namespace transformesh {

/// Returns the edges of the pieces whose `included` entry is nonzero. Other pieces have no edges.
Edges piece_edges(const Arrangement& arrangement, const std::vector<char>& included);

Index halfedge_source(std::span<const Piece> pieces, Index halfedge);
Index halfedge_target(std::span<const Piece> pieces, Index halfedge);

/// True if the halfedge runs from the smaller to the larger point or vertex index.
bool is_forward(std::span<const Piece> pieces, Index halfedge);
inline bool is_forward(std::span<const Face> faces, Index halfedge) {
  return faces[halfedge / 3][halfedge % 3] < faces[halfedge / 3][(halfedge % 3 + 1) % 3];
}

/// Returns the halfedges of one edge in counter-clockwise order, viewed against the forward
/// direction. The order starts with the face of halfedges[0] and the faces that coincide with this
/// face. Exact. The front of a face with a forward halfedge is towards the next face in the order.
/// The back of a face with a backward halfedge is towards the next face. Among coincident faces of
/// a mesh, forward faces come first. Then their fronts are towards each other, like those of
/// touching bodies.
std::vector<Index> sort_around_edge(const Arrangement& arrangement,
                                    std::span<const Index> halfedges);
std::vector<Index> sort_around_edge(const Mesh& mesh, std::span<const Index> halfedges);

}  // namespace transformesh
