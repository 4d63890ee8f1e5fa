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

/// Moves each vertex towards the center of its star within the plane that keeps the volume: the one
/// across its area normal. Vertices move one after the other, in slot order, so that the volume of
/// a closed mesh stays up to rounding. Attributes are interpolated where the vertex slides to.
/// Vertices on lines slide along them. A move that would turn a normal by more than 60 degrees,
/// make a poor triangle poorer or might make contact is halved, then refused. Where there is
/// a `surface`, free vertices move on to its closest point. Without one, `curved` moves them onto
/// the quadric through the vertices around (curved_edge.h), which keeps curvature rather than
/// volume.
SmoothCounts relax_tangentially(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                                const ClosestPointQuery* surface, const Progress& progress,
                                bool curved = false);

/// v -> v - first dv + second d2v with the Laplace-Beltrami operator dv = v - sum w_j v_j / sum
/// w_j, w_j the sum of the cotangents of the angles opposite the edge (Desbrun et al., "Implicit
/// fairing of irregular meshes", SIGGRAPH 1999; the form with two factors is the paper's). Angles
/// count as at least 5 degrees and weights as at least a hundredth, so that dv points into the star
/// whatever the triangles; d2v is the same operator applied to dv. All moves are computed before
/// the first.
SmoothCounts smooth_laplace(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                            double first, double second, const Progress& progress);

}  // namespace transformesh
