/// Brings parts of the given initial mesh (the start) back into the surface of a reconstruction,
/// where photographs agree on the initial mesh as well.
#pragma once

#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// A surface, and the disagreement of photographs around each vertex (Disagreement::of_vertex).
struct MeasuredMesh {
  const Mesh& mesh;
  const std::vector<WindowSums>& sums;
};

/// Moves vertices of `result` to the closest points of `start` within `reach`, unless photographs
/// agree clearly better on `result` around the vertex (is_clearly_less() in start_comparison.h).
/// For this comparison, adds WindowSums over the four rings of neighbors around each vertex.
/// Vertices that fewer than two views observe stay. Between parts that move and parts that stay,
/// movements decrease smoothly. Faces do not change; the surface may intersect itself afterwards.
/// Returns the share of the vertices that moved by half of the way or more. Throws InputError if
/// `start` has no faces.
double restore_better_parts(Mesh& result, const std::vector<WindowSums>& of_result,
                            const MeasuredMesh& start, double reach);

}  // namespace transformesh
