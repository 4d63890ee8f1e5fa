/// Brings parts of a given start back into the surface of a reconstruction, where photographs agree
/// on the start as well.
#pragma once

#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// A surface, and Disagreement::of_vertex of its vertices.
struct MeasuredMesh {
  const Mesh& mesh;
  const std::vector<WindowSums>& sums;
};

/// Moves vertices of `result` to the closest points of `start` within `reach`, unless photographs
/// agree clearly better on `result` around the vertex: is_clearly_less() of start_comparison.h.
/// Compares sums over four rings of vertices. Vertices that no two views observe stay. Between
/// parts that move and parts that stay, movements decrease smoothly. Faces do not change; the
/// surface may intersect itself afterwards. Returns the share of the vertices that moved by half of
/// the way or more. Throws InputError if the start has no faces.
double restore_better_parts(Mesh& result, const std::vector<WindowSums>& of_result,
                            const MeasuredMesh& start, double reach);

}  // namespace transformesh
