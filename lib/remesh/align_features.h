/// Aligns a mesh that lies near a target with the target's sharp edges: a vertex at every corner,
/// vertices along every sharp edge, and mesh edges from one to the next, where the mesh before ran
/// across, which cuts sharp edges off.
///
/// Vertices are moved onto the nearest sharp edge where one of their edges crosses it, nearest ones
/// first; edges are flipped where that brings their middles nearer to the target; then short edges
/// are collapsed, the rest relaxes onto the target, and what is on a sharp edge slides along it.
/// (As in Kobbelt, Botsch, Schwanecke & Seidel, "Feature sensitive surface extraction from volume
/// data", SIGGRAPH 2001, but for vertices that exist.)
///
/// Guarantees what remesh() does: an oriented manifold of the same topology, no self-intersection
/// made (embedding_guard.h), poor triangles not made poorer by moves, attributes blended. Not
/// guaranteed: that all sharp edges are met; where a step would break a guarantee they stay cut
/// off. Sharp edges nearer to each other than the mesh's edges are merged at best. Deterministic;
/// O(n log n).
#pragma once

#include "mesh/mesh.h"
#include "mesh/surface_columns.h"
#include "remesh/guards/edge_rules.h"
#include "support/progress.h"

namespace transformesh {

struct AlignOptions {
  double feature_angle_deg = 40;        ///< sharp edges: faces turn by more; in (0, 180)
  EdgeLimits limits;                    ///< of the mesh's edges, input units
  Scalar coordinate = Scalar::float64;  ///< new positions are rounded to this type, then checked
};

struct AlignResult {
  std::size_t sharp_edges = 0;  ///< of the target
  std::size_t corners = 0;      ///< of the target: where sharp edges end, turn or meet
  std::size_t aligned = 0;      ///< vertices on sharp edges and corners at the end
  StaleColumns columns;
};

/// Whether the target has sharp edges for certain, and not by noise or coarseness: edges by 60
/// degrees and more are at least a fiftieth of the length of all.
bool has_features(const Mesh& target);

/// Throws UsageError for options out of range, InputError for what is no oriented manifold or has
/// no faces. A target without sharp edges changes nothing.
AlignResult align_features(Mesh& mesh, const Mesh& target, const AlignOptions& options,
                           const Progress& progress = {});

}  // namespace transformesh
