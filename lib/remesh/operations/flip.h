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
  std::size_t refused = 0;  ///< flips that the guard refused
};

/// Flips edges by a rule. FlipRule::angle flips an edge if the least angle of its two faces
/// increases. FlipRule::valence flips an edge if the sum of the squared deviations from valence 6
/// (4 on borders) decreases, or if it stays equal and the least angle increases.
///
/// Edges on lines, and between faces whose normals differ by more than 60 degrees, are not flipped.
/// A flip must not make an existing edge, rotate a normal by more than 60 degrees, or make an edge
/// that is too long. Stretched edges (edge_rules.h) are made only if the surface hardly moves.
/// Edges are tried in order, then again around each flipped edge.
FlipCounts flip_edges(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule,
                      const EdgeLimits& limits, const Progress& progress);

/// Flips an edge if the conditions of flip_edges() hold, without a rule. Without limits, edges do
/// not become longer.
bool flip_edge(EditableMesh& mesh, EmbeddingGuard& guard, Index halfedge,
               const EdgeLimits& limits = {});

}  // namespace transformesh
