/// Collapses edges shorter than half the tolerance of flat regions. Also removes vertices of faces
/// with edges shorter than the tolerance, if the surface around them is flat (flat_vertices.h).
/// Short edges would keep unneeded vertices on the outlines of regions.
///
/// Guarantees for an oriented manifold: the result has the same topology, and no vertex moves. If a
/// changed face intersects another face, the mesh does not change. Deterministic. Cost: that of
/// flat_vertices.h and broken_faces.h.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Changes faces at vertices of marked faces; `wanted` is updated to the new faces. A vertex is
/// removed only if no other vertex has its position. Returns the displacement of the surface.
Displacement collapse_short_edges(Mesh& mesh, std::vector<char>& wanted,
                                  const std::vector<char>& has_copy, double spacings,
                                  Scalar coordinate);

}  // namespace transformesh
