/// Angles less multiples of a quarter turn.
#pragma once

#include "support/elementary/double_double.h"

namespace transformesh::elementary {

struct ReducedAngle {
  int quarters = 0;   ///< taken off, modulo 4
  DoubleDouble rest;  ///< at most pi/4 in magnitude, but for rounding; to 60 bits or more
};

/// Of any finite angle.
ReducedAngle reduced_angle(double x);

}  // namespace transformesh::elementary
