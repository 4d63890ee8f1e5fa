/// Functions to 200 bits by MPFR, and how far others are off.
#pragma once

#include <mpfr.h>

#include <vector>

#include "helpers/random.h"

namespace transformesh::test {

using ExactFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using ExactFunctionOfTwo = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/// In units in the last place of the exact value: the distance of two doubles where it is. Infinity
/// is right for what rounds to it, and else counts as the power of two beyond the largest double.
/// What is exactly 0, infinite or not a number must be so.
double units_off(double result, ExactFunction function, double x);
double units_off(double result, ExactFunctionOfTwo function, double x, double y);

/// Of either sign; each exponent from `low` to `high`, of powers of 2, is as likely.
double any_number(Random& random, int low, int high);

/// A number and its neighbors, `count` on each side, in increasing order.
std::vector<double> neighborhood(double x, int count);

/// The same digits and the same sign of 0, or neither is a number.
bool is_same(double a, double b);

}  // namespace transformesh::test
