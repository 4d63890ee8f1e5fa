/// A conservative test for contact of two triangles: rounding errors count as contact. Two
/// triangles are certainly apart if a plane separates them with a margin far above rounding errors.
/// Several planes are tried, and any of them is a proof. Corners with equal coordinates count as a
/// common corner.
#pragma once

#include <span>

#include "mesh/triangle.h"

namespace transformesh {

/// Returns false only if the triangles certainly share no point other than common corners and the
/// edge between two common corners. Returns true for contact, for distances within rounding errors,
/// for equal triangles, and if a triangle without area comes near the other beyond a single common
/// corner. Also returns true for faces that fold onto each other at a common edge, with an angle
/// below a thousandth of a radian.
bool may_touch(const Triangle& first, const Triangle& second);

/// True if may_touch() is true for two of the triangles. Tests all pairs, except for many triangles
/// with the same first corner: O(n log n) if few of these are near each other.
bool meet_each_other(std::span<const Triangle> triangles);

}  // namespace transformesh
