/// How far rounding and its repair moved a surface at most (paper 4.3). Distances are local: they
/// are counted in spacings of numbers at the place where something moves, so that a far vertex
/// excuses nothing near the origin.
#pragma once

#include <algorithm>

#include "mesh/coordinate_spacing.h"

namespace transformesh {

struct Displacement {
  double spacings = 0;  ///< in spacings at the largest coordinate of the point that moved
  double length = 0;    ///< in units of the coordinates

  /// Notes one of several points that move at the same time.
  void note(double distance, double spacing) {
    spacings = std::max(spacings, distance / spacing);
    length = std::max(length, distance);
  }
  /// Notes another point, with all its movements.
  void note(const Displacement& other) {
    spacings = std::max(spacings, other.spacings);
    length = std::max(length, other.length);
  }
  /// Notes what moves the surface once more.
  Displacement& operator+=(const Displacement& next) {
    spacings += next.spacings;
    length += next.length;
    return *this;
  }
};

}  // namespace transformesh
