/// Smooths the heights of vertices over the surface that they sample.
#pragma once

#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/vertex_role.h"
#include "transformesh/control.h"

namespace transformesh {

/// Splits, collapses and relaxation leave vertices a little above or below the surface. The height
/// of a vertex over the mean of its neighbors measures curvature. At a misplaced vertex it differs
/// from the heights of the neighbors. Each free vertex moves along its normal by three tenths of
/// the difference. The difference is the Laplacian of a Laplacian, so smooth parts do not shrink.
/// On well-sampled surfaces, the largest distance to the input decreases by a tenth to a sixth.
/// Vertices at creases and lines stay. All movements are computed before the first one. If
/// VertexMover refuses a movement, half of it is tried, then the vertex stays.
void smooth_bilaplacian(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                        const Progress& progress);

}  // namespace transformesh
