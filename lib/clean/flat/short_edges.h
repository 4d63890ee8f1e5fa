/// Collapses edges that are shorter than the tolerance of flat regions, and vertices of faces with
/// such edges around which the surface is flat (flat_vertices.h). Such edges would keep vertices on
/// the outlines of regions that nothing needs.
///
/// Guaranteed for an oriented manifold: the result has the same topology and no vertex moved. If
/// one of the changed faces intersects another one, the mesh stays as it was. Deterministic.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Changes faces at vertices of those marked in `wanted`, whose marks follow the faces. A vertex
/// goes only if no other one has its position. Returns how far the surface moved.
Displacement collapse_short_edges(Mesh& mesh, std::vector<char>& wanted,
                                  const std::vector<char>& has_copy, double spacings,
                                  Scalar coordinate);

}  // namespace transformesh
