/// Pairs the halfedges of pieces that continue each other across an edge (paper 3.3). The corners
/// of pieces are points. The umbrellas of the paired pieces become the vertices. More than two
/// pieces meet at a singular edge (paper 3.3.2).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/edges.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Sorts the halfedges of one edge by angle: counter-clockwise, viewed against the direction from
/// the smaller to the larger point. Called from several threads.
using AngularSort = std::function<std::vector<Index>(std::span<const Index> halfedges)>;

/// Returns the opposite of each halfedge, or no_index on a border. At a singular edge, two pieces
/// are paired if the inside is between them, behind both; then sheets never intersect. If more
/// pieces traverse the edge in one direction than in the other, the surplus has no partner.
/// `component_of` gives the open component of each piece, or no_index for the closed part; it is
/// empty if all pieces are closed. An open component with exactly two pieces at an edge continues
/// across it, and so does the closed part, regardless of other pieces. Cost: O(n) plus sorting.
std::vector<Index> pair_across_inside(std::span<const Face> faces, const Edges& edges,
                                      const AngularSort& sort,
                                      std::span<const Index> component_of = {});

}  // namespace transformesh
