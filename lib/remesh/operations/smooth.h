/// Moves vertices: tangential relaxation, and the two Laplacians of paper 5.1.2.
#pragma once

#include "geometry/search/closest_point.h"
#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/vertex_role.h"
#include "transformesh/control.h"

namespace transformesh {

struct SmoothCounts {
  std::size_t moved = 0;
  std::size_t refused = 0;
};

/// Tangential relaxation. Moves each vertex towards the centroid of its star, in the plane through
/// the vertex perpendicular to its area normal. Such movements keep the volume. Vertices move one
/// after the other, in slot order, so that the volume of a closed mesh stays up to rounding.
/// Attributes are interpolated at the new position. Vertices on lines slide along them.
///
/// A movement must not rotate a normal by more than 60 degrees, make a poor triangle poorer, or
/// make contact. Otherwise it is halved, then refused. If there is a `surface`, free vertices then
/// move to its closest point. Without a `surface`, and with `curved`, free vertices move onto the
/// quadric that fits the vertices around them (curved_edge.h). This keeps curvature instead of
/// volume.
SmoothCounts relax_tangentially(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                                const ClosestPointQuery* surface, const Progress& progress,
                                bool curved = false);

/// Laplacian smoothing: v -> v - first dv + second d2v. The Laplace-Beltrami operator is dv = v -
/// sum w_j v_j / sum w_j. Here w_j is the sum of the cotangents of the angles opposite the edge,
/// and d2v is the operator applied to dv. Angles count as at least 5 degrees, and weights as at
/// least a hundredth, so that dv points into the star for any triangles. All movements are computed
/// before the first one. References: Desbrun, Meyer, Schroeder & Barr, "Implicit fairing of
/// irregular meshes using diffusion and curvature flow", SIGGRAPH 1999; paper 5.1.2 for the form
/// with two factors.
SmoothCounts smooth_laplace(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                            double first, double second, const Progress& progress);

}  // namespace transformesh
