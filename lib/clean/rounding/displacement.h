/// Upper bounds of how far rounding and its repair moved a surface (paper 4.3). Distances are also
/// measured in spacings of numbers at the place of the movement. Hence a large coordinate elsewhere
/// does not hide a large movement near the origin.
#pragma once

#include <algorithm>

#include "mesh/coordinate_spacing.h"

namespace transformesh {

struct Displacement {
  double spacings = 0;  ///< distance in spacings at the largest coordinate of the moved point
  double length = 0;    ///< distance in units of the coordinates

  /// Adds a point that moves at the same time as the earlier points: takes the maximum.
  void note(double distance, double spacing) {
    spacings = std::max(spacings, distance / spacing);
    length = std::max(length, distance);
  }
  /// Adds the displacement of another point: takes the maximum.
  void note(const Displacement& other) {
    spacings = std::max(spacings, other.spacings);
    length = std::max(length, other.length);
  }
  /// Adds a movement that follows the earlier movements: takes the sum.
  Displacement& operator+=(const Displacement& next) {
    spacings += next.spacings;
    length += next.length;
    return *this;
  }
};

}  // namespace transformesh
