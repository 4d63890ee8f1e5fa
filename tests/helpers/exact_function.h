/// Errors of functions in units in the last place, measured with MPFR at 200 bits.
#pragma once

#include <mpfr.h>

#include <vector>

#include "helpers/random.h"

namespace transformesh::test {

using ExactFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using ExactFunctionOfTwo = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/// Returns the error of `result` in units in the last place of the exact value. If the exact value
/// rounds to infinity, an infinite result is correct. Otherwise an infinite result counts as the
/// power of two beyond the largest double. If the exact value is 0, infinite or not a number, the
/// result must be the same, or the error is infinite.
double units_off(double result, ExactFunction function, double x);
double units_off(double result, ExactFunctionOfTwo function, double x, double y);

/// Returns a random number of either sign. All binary exponents from `low` to `high` are equally
/// likely.
double any_number(Random& random, int low, int high);

/// Returns a number and its neighboring doubles, `count` on each side, in increasing order.
std::vector<double> neighborhood(double x, int count);

/// True if both numbers are equal, with equal signs of zero, or if neither is a number.
bool is_same(double a, double b);

}  // namespace transformesh::test
