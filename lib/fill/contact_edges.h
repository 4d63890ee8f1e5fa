/// Separates bodies that are connected only because faces at an edge along which they touch are
/// missing. If each body lacks one of its two faces at the edge, the two remaining faces look like
/// neighbors, and one hole surrounds both gaps. An edge is cut if it connects two vertices of a
/// border loop, so that the cut makes two loops. Their patches must not fold back onto the faces at
/// the loops, nor have much more area than a patch of the whole loop. Deterministic.
#pragma once

#include <functional>
#include <vector>

#include "fill/hole_loops.h"

namespace transformesh {

/// Cuts the mesh at such edges: at each end of the edge, the faces on one side get a copy of the
/// vertex, with its columns. `separate` has the faces before vertices at which holes touch were
/// joined; they are cut, too. Replaces each loop that is cut by two. `may_fill` tells whether a
/// loop will be filled; an edge is cut only if both new loops will. Precondition: all edges are
/// manifold and oriented. Returns the number of cut edges. Cost: O(n), and that of triangulations
/// of loops.
std::size_t cut_contact_edges(Mesh& mesh, std::vector<Face>& separate, std::vector<HoleLoop>& loops,
                              const std::function<bool(const HoleLoop&)>& may_fill);

}  // namespace transformesh
