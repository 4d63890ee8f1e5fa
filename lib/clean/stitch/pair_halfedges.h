/// Pairs the halfedges of pieces (triangles of an arrangement) that become neighbors across an edge
/// (paper 3.3). The corners of pieces are indices of points. Afterwards each umbrella (connected
/// pieces around a point) becomes one vertex of the result. A singular edge has more than two
/// pieces (paper 3.3.2).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/edges.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Function that sorts the halfedges of one edge by the angles of their faces around the edge. The
/// order is counter-clockwise, viewed against the direction from the smaller to the larger point
/// index. Called from several threads.
using AngularSort = std::function<std::vector<Index>(std::span<const Index> halfedges)>;

/// Returns the opposite of each halfedge, or no_index on a border. A piece is a triangle of the
/// arrangement. At an edge of more than two pieces, two pieces are paired if the inside is between
/// them, behind both. Hence sheets touch at the edge, but do not intersect there. If more pieces
/// traverse the edge in one direction than in the other, the excess pieces are not paired.
/// `component_of` gives the open component of each piece, or no_index for the closed part; it is
/// empty if all pieces are closed. If an open component has exactly two pieces at an edge, these
/// are paired, regardless of other pieces. The pieces of the closed part are paired among
/// themselves, too. Cost: O(n) plus sorting.
std::vector<Index> pair_across_inside(std::span<const Face> faces, const Edges& edges,
                                      const AngularSort& sort,
                                      std::span<const Index> component_of = {});

}  // namespace transformesh
