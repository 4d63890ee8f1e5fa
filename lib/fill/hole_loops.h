/// Finds the border loops of holes, also of holes that touch at a vertex. Several umbrellas
/// (umbrellas.h) meet at such a vertex, or tm-stitch has given each umbrella a copy of the vertex.
/// Border edges alone do not determine which umbrellas are neighbors across a hole. Each border
/// edge that ends at the vertex is therefore continued by the first one in the direction of the
/// hole, seen along the mean normal. A loop ends if it passes a vertex again. Cost: O(n) and
/// O(b log b) for b border edges. Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// A boundary loop as a list of border halfedges; each halfedge starts where the previous one ends.
using HoleLoop = std::vector<Index>;

/// Joins vertices at which holes touch, and returns the border loops. A loop passes each vertex at
/// most once. `border` has the border halfedges in ascending order. Precondition: all edges are
/// manifold and oriented.
std::vector<HoleLoop> join_touching_holes(Mesh& mesh, const std::vector<Index>& border);

/// Joins vertices at which loops of one hole touch. An island may touch the rim of its hole, and
/// one patch fills the space between them. Vertices stay apart if edges would coincide.
void join_touching_loops(Mesh& mesh, const std::vector<std::vector<HoleLoop>>& holes);

/// Reverts joins at vertices whose holes are still open: gives each umbrella its own vertex, if
/// possible the one in `before`, which has the faces before they were joined. Drops vertices
/// without faces.
void separate_open_holes(Mesh& mesh, const std::vector<Face>& before);

}  // namespace transformesh
