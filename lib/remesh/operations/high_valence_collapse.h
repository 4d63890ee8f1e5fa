/// Collapses short edges around vertices of very high valence, before all other operations.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/vertex_role.h"
#include "transformesh/control.h"

namespace transformesh {

/// Collapses short edges opposite to vertices with a valence above 256, the shortest first, by the
/// rules of collapse_short_edges(), until the valence is at most 256. The embedding guard would
/// test all n faces of such a star for each collapse, which takes O(n^2). Instead, the whole mesh
/// is searched for intersections at the end; if there are any, the mesh stays unchanged. Returns
/// the number of collapses. Cost: O(n log n); O(n) for a mesh without such vertices.
std::size_t collapse_high_valence_stars(EditableMesh& mesh, bool keep_border,
                                        const EdgeLimits& limits, const Progress& progress);

}  // namespace transformesh
