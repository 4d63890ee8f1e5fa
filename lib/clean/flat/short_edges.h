/// Collapses edges shorter than half the tolerance of flat regions (merge_flat.h). If a face has an
/// edge shorter than the tolerance, also removes its vertices around which the surface is flat
/// (rounding/flat_vertices.h). Short edges would keep unneeded vertices on the outlines of regions.
///
/// Guarantees for an oriented manifold: the result has the same topology, and no vertex moves. If a
/// changed face intersects another face, the mesh does not change. Deterministic. Cost: that of
/// flat_vertices.h and broken_faces.h.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Removes vertices of faces with a nonzero `wanted` entry; `wanted` is updated to the faces of the
/// result, including changed faces. A vertex is removed only if no other vertex has its position
/// (`has_copy`). Returns the displacement of the surface.
Displacement collapse_short_edges(Mesh& mesh, std::vector<char>& wanted,
                                  const std::vector<char>& has_copy, double spacings,
                                  Scalar coordinate);

}  // namespace transformesh
