/// Flips edges, towards valence six or towards larger angles.
#pragma once

#include "remesh/guards/edge_rules.h"
#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/vertex_role.h"
#include "transformesh/control.h"
#include "transformesh/remesh.h"

namespace transformesh {

struct FlipCounts {
  std::size_t done = 0;
  std::size_t refused = 0;  ///< by the guard
};

/// With FlipRule::valence flips where the squared deviations from valence 6 (4 on borders)
/// get smaller, or stay as they are and the smaller of the least angles grows. With FlipRule::angle
/// where the smaller of the least angles grows. No flip makes an edge that exists, takes one on a
/// line or between faces that meet at more than 60 degrees, turns a normal by more than that, or
/// makes an edge longer than allowed; stretched ones are made only where the surface hardly moves.
/// Edges are tried in order, then again around each that was flipped.
FlipCounts flip_edges(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule,
                      const EdgeLimits& limits, const Progress& progress);

/// Flips one edge where the result is sound, whatever the rule. Without limits, edges do not become
/// longer.
bool flip_edge(EditableMesh& mesh, EmbeddingGuard& guard, Index halfedge,
               const EdgeLimits& limits = {});

}  // namespace transformesh
