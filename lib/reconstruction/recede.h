/// Moves parts of a surface inwards on which photographs disagree. This is a part of carving
/// (carving.h).
///
/// The visual hull contains the object, so that a part on which photographs disagree lies outside
/// of the object. Such a part often continues where fewer than two views observe it, as a filling
/// between two strands does. Its unobserved area then moves inwards too. The unobserved lower side
/// of an object on a table stays, because photographs agree on the surface around it.
#pragma once

#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// Moves vertices inwards along their normals, by up to `distance`. `sums` is
/// Disagreement::of_vertex. The movement of a vertex that two views observe depends on
/// WindowSums::excess of all windows in the two rings of vertices around it. If the excess is at
/// most 0.4, the vertex stays. From 0.8 on, it moves by `distance`. The movement is linear between
/// these values. Unobserved vertices move together with the moving vertices to which they are
/// connected. Each moves by `distance` times the ratio of moving area to unobserved area of the
/// connected set, at most 1. O(n).
void move_contradicted_inwards(Mesh& mesh, const std::vector<WindowSums>& sums, double distance);

}  // namespace transformesh
