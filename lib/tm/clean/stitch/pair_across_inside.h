/// Stitching pieces that know their corners only as points (paper 3.3): which pieces continue each
/// other across an edge. The fans that they then form are the vertices.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tm/mesh/edges.h"
#include "tm/mesh/mesh.h"

namespace transformesh {

/// Brings the halfedges of one edge into angular order: counter-clockwise seen against the
/// direction from the smaller to the larger point.
using AngularSort = std::function<std::vector<Index>(std::span<const Index> halfedges)>;

/// The halfedge of the piece across each halfedge; no_index on a border. At a singular edge pieces
/// pair across the inside, behind both, so that sheets never cross; as many stay without a partner
/// as more run one way than the other.
std::vector<Index> pair_across_inside(std::span<const Face> faces, const Edges& edges,
                                      const AngularSort& sort);

}  // namespace transformesh
