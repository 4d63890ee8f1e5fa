/// Pairs of faces that intersect only because coordinates were rounded.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns how many pairs of faces intersect in `rounded` and not with the positions `before`
/// rounding. Cost: find_intersections() once, and again for the faces that intersect.
std::size_t count_rounding_intersections(const Mesh& rounded, const std::vector<Vec3>& before);

/// The same for a mesh whose coordinates are to be rounded to `type`. Returns 0 without a search
/// if the spacing of the coordinates is below a thousandth of the mean edge.
std::size_t count_rounding_intersections(const Mesh& mesh, Scalar type);

}  // namespace transformesh
