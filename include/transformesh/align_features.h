/// Aligns a mesh that lies near a target with the target's sharp edges. A mesh edge that crosses a
/// sharp edge of the target bevels it. Afterwards there is a vertex at each corner of the target,
/// and vertices and mesh edges along each sharp edge.
///
/// Moves vertices onto the nearest sharp edge if one of their edges crosses it, the nearest
/// vertices first. Flips edges if this brings their midpoints nearer to the target. Collapses short
/// edges, relaxes the other vertices onto the target, and slides aligned vertices along their sharp
/// edges. Reference: Kobbelt, Botsch, Schwanecke & Seidel, "Feature sensitive surface extraction
/// from volume data", SIGGRAPH 2001, who insert new vertices instead of moving existing ones.
///
/// Guarantees of remesh(): an oriented manifold of the same topology, no new self-intersection
/// (embedding_guard.h), interpolated attributes. Moves do not make poor triangles poorer. Some
/// sharp edges may remain unaligned. A step that would break a guarantee is left out. Sharp edges
/// nearer to each other than the mesh's edge length cannot be resolved separately. Deterministic;
/// O(n log n).
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct AlignOptions {
  /// An edge is sharp if its normals differ by at least this angle; in (0, 180).
  double feature_angle_deg = 40;
  double min_edge = 0;                  ///< length of the mesh's shortest edges; input units; > 0
  double max_edge = 0;                  ///< length of the mesh's longest edges; input units
  Scalar coordinate = Scalar::float64;  ///< new positions are rounded to this type, then checked
};

struct AlignResult {
  std::size_t sharp_edges = 0;  ///< number of sharp edges of the target
  /// Number of corners of the target: vertices where sharp edges end, turn or meet.
  std::size_t corners = 0;
  std::size_t aligned = 0;  ///< number of vertices on sharp edges and corners at the end
  StaleColumns columns;
};

/// True if the target certainly has sharp edges, not only noise or coarse curvature. Edges of at
/// least 60 degrees must make up more than 1/50 of the length of all edges.
bool has_features(const Mesh& target);

/// Throws UsageError for options out of range. Throws InputError if the mesh is not an oriented
/// manifold or has no faces. Does nothing if the target has no sharp edges.
AlignResult align_features(Mesh& mesh, const Mesh& target, const AlignOptions& options,
                           const Progress& progress = {});

}  // namespace transformesh
