/// Collapses edges that are short, or whose collapse makes valences regular.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/vertex_role.h"
#include "transformesh/control.h"

namespace transformesh {

struct CollapseCounts {
  std::size_t done = 0;
  std::size_t refused = 0;     ///< remaining short edges
  std::size_t films_kept = 0;  ///< collapses refused only because of ShapeRules::min_film
};

/// Collapses edges shorter than `limits.shortest`, the shortest first. A collapse must keep the
/// topology (link condition; a closed component keeps four faces) and rotate no normal by more than
/// 60 degrees. It must make no sliver, no too long edge and no contact. The merged vertex lies at
/// the end that must stay, or else at the midpoint, shifted along the normal so that the volume
/// stays. Reference: Lindstrom & Turk, "Fast and memory efficient polygonal simplification",
/// Visualization 1998.
/// ShapeRules::curved chooses among both ends and the middle of the curved edge the position with
/// the least sum of squared distances to the planes of the replaced faces. Reference: Garland &
/// Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.
CollapseCounts collapse_short_edges(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, const EdgeLimits& limits,
                                    const Progress& progress);

/// Collapses edges of up to 1.15 times the shortest length if that brings the valences around
/// closer to six. The rules are those of collapse_short_edges(), but edges may be stretched
/// (edge_rules.h). Returns the number of collapses.
std::size_t collapse_for_valence(EditableMesh& mesh, EmbeddingGuard& guard,
                                 const VertexRoles& roles, const EdgeLimits& limits,
                                 const Progress& progress);

/// Tries to collapse an edge of any length, by the rules of collapse_short_edges().
bool collapse_edge(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                   Index halfedge, const EdgeLimits& limits);

}  // namespace transformesh
