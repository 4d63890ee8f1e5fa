/// Which pieces continue each other across an edge (paper 3.3). Pieces know their corners only as
/// points; the umbrellas that they form when they are paired are the vertices. At a singular edge
/// (paper 3.3.2) more than two pieces meet.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/edges.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Brings the halfedges of one edge into angular order: counter-clockwise seen against the
/// direction from the smaller to the larger point.
using AngularSort = std::function<std::vector<Index>(std::span<const Index> halfedges)>;

/// For each halfedge that of the piece across it; no_index on a border. At a singular edge pieces
/// pair across the inside, which is behind both, so that sheets never intersect. If more have one
/// direction than the other, the surplus stays without a partner. `component_of` gives the open
/// component of each piece, no_index for the closed part; it is empty if all is closed. A component
/// of which two pieces meet an edge continues there, and so does the closed part, whatever others
/// end there. Cost: O(n) and that of sorting.
std::vector<Index> pair_across_inside(std::span<const Face> faces, const Edges& edges,
                                      const AngularSort& sort,
                                      std::span<const Index> component_of = {});

}  // namespace transformesh
