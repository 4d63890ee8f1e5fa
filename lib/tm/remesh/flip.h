/// Turns edges within their two faces, for valence six or for larger angles.
#pragma once

#include "tm/remesh/edge_rules.h"
#include "tm/remesh/embedding_guard.h"
#include "tm/remesh/vertex_role.h"
#include "tm/support/progress.h"

namespace transformesh {

struct FlipCounts {
  std::size_t done = 0;
  std::size_t refused = 0;  ///< by the guard
};

/// FlipRule::valence: flips where the squared deviations from valence 6 (4 on borders)
/// get smaller, or stay as they are and the smaller of the least angles grows. FlipRule::angle:
/// where the smaller of the least angles grows. Never an edge that exists, one on a line, one
/// across faces that meet at more than 60 degrees; never a normal turned by more than that, nor an
/// edge longer than allowed; a stretched one only where the surface hardly moves. The lowest edge
/// first, then again around what was flipped.
FlipCounts flip_edges(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule,
                      const EdgeLimits& limits, const Progress& progress);

/// Flips one edge where the result is sound, whatever the rule.
bool flip_edge(EditableMesh& mesh, EmbeddingGuard& guard, Index halfedge);

}  // namespace transformesh
