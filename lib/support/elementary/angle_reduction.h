/// Reduction of angles modulo a quarter turn.
#pragma once

#include "support/elementary/double_double.h"

namespace transformesh::elementary {

struct ReducedAngle {
  int quarters = 0;  ///< number of subtracted quarter turns, modulo 4
  /// Remaining angle: magnitude at most pi/4, up to rounding; precise to at least 60 bits.
  DoubleDouble rest;
};

/// Reduces any finite angle, in radians.
ReducedAngle reduced_angle(double x);

}  // namespace transformesh::elementary
