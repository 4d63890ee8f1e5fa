/// Counts pairs of faces that intersect only because coordinates were rounded.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the number of pairs of faces that intersect in `rounded`, but not with the positions
/// `before` rounding. Cost: find_intersections() once, and again for the faces that intersect.
std::size_t count_rounding_intersections(const Mesh& rounded, const std::vector<Vec3>& before);

/// Returns the number of pairs of faces that would intersect only after rounding the coordinates to
/// `type`. Returns 0 without a search if the spacing of the coordinates is below a thousandth of
/// the mean edge length.
std::size_t count_rounding_intersections(const Mesh& mesh, Scalar type);

}  // namespace transformesh
