/// Collapses short edges around vertices of very high valence, before all else.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/vertex_role.h"
#include "support/progress.h"

namespace transformesh {

/// Collapses edges that are shorter than the shortest allowed and lie opposite to a vertex of a
/// valence above 256, by the rules of collapse_short_edges() and the shortest first, while that
/// valence is above 256. The embedding guard asks all faces of such a star for each collapse, which
/// takes O(n^2) for n of them; instead, the whole mesh is searched for intersections at the end. If
/// it has any the mesh stays as it was. Returns the number of collapses. Cost: O(n log n), and O(n)
/// for a mesh without such a vertex.
std::size_t collapse_high_valence_stars(EditableMesh& mesh, bool keep_border,
                                        const EdgeLimits& limits, const Progress& progress);

}  // namespace transformesh
