#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the length of a vector without overflow or underflow of squares.
inline double length_of(const Vec3& vector) {
  // Squares of lengths between `small` and `large` are normal numbers, and their sums do not
  // overflow.
  constexpr double small = 1e-60, large = 1e60;
  const double length = vector.norm();
  return length > small && length < large ? length : vector.stableNorm();
}

}  // namespace transformesh
