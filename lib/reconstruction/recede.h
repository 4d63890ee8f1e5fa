/// Moves parts of a surface inwards that photographs do not confirm. A step of carving (carving.h).
///
/// The visual hull contains the object, so that a part on which photographs disagree lies outside
/// of the object. Such a part often continues where fewer than two views observe it, as a plug
/// between strands does. Its unobserved area then recedes too. The lower side of an object on a
/// table, whose surroundings are confirmed, stays.
#pragma once

#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// Moves vertices inwards along their normals, by up to `distance`. `sums` is
/// Disagreement::of_vertex. The excess of all windows in two rings around an observed vertex
/// decides how far the vertex moves. Up to 0.4 it stays, from 0.8 on it moves by `distance`, and
/// in proportion between. Unobserved vertices of a connected set of moving and unobserved vertices
/// move by the ratio of moving area to unobserved area, at most 1. O(n).
void move_contradicted_inwards(Mesh& mesh, const std::vector<WindowSums>& sums, double distance);

}  // namespace transformesh
