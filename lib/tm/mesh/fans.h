/// The fans of a mesh: faces around a vertex that hang together across edges. A vertex of a
/// manifold has one; its corners elsewhere fall into several. Orientation plays no part.
/// Cost: O(n); deterministic.
#pragma once

#include <vector>

#include "tm/mesh/disjoint_sets.h"
#include "tm/mesh/edges.h"
#include "tm/mesh/mesh.h"

namespace transformesh {

struct Fans {
  /// Of the corners 3 * face + i. Corners of one vertex are together when edges with exactly two
  /// faces lead from one to the other.
  DisjointSets corners;
  std::vector<Index> count;  ///< per vertex; 0 where no face uses it
};

Fans find_fans(const Mesh& mesh, const Edges& edges);

/// The lowest border halfedge (one on an edge with a single face) of each boundary loop. Where
/// several fans meet at a vertex, loops follow the fan.
std::vector<Index> boundary_loops(const Mesh& mesh, const Edges& edges, Fans fans);

}  // namespace transformesh
