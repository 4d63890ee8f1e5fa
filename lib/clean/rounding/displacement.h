/// Upper bounds of how far rounding and its repair moved a surface (paper 4.3). A distance is
/// stored as a length and in spacings. The spacing is the distance of neighboring floating-point
/// numbers at the place of the movement. Hence a large coordinate elsewhere does not hide a large
/// movement near the origin.
#pragma once

#include <algorithm>

#include "mesh/coordinate_spacing.h"

namespace transformesh {

struct Displacement {
  /// Distance, divided by the spacing of numbers at the largest coordinate of the moved point.
  double spacings = 0;
  double length = 0;  ///< distance in units of the coordinates

  /// Records the movement of a point in the same step as earlier points: takes the maximum.
  void note(double distance, double spacing) {
    spacings = std::max(spacings, distance / spacing);
    length = std::max(length, distance);
  }
  /// Records the displacement of other points in the same step: takes the maximum.
  void note(const Displacement& other) {
    spacings = std::max(spacings, other.spacings);
    length = std::max(length, other.length);
  }
  /// Records a further step that may move the same points again: takes the sum.
  Displacement& operator+=(const Displacement& next) {
    spacings += next.spacings;
    length += next.length;
    return *this;
  }
};

}  // namespace transformesh
