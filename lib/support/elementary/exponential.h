/// Exponentials and logarithms that are the same on every machine, by IEEE operations alone: those
/// of libm differ in the last digit from processor to processor.
/// Errors are at most .52 units in the last place, and one where a result is subnormal.
/// References: Tang, "Table-driven implementation of the exponential function in IEEE
/// floating-point arithmetic", ACM TOMS 15, 1989, and of the logarithm, ACM TOMS 16, 1990; Muller,
/// "Elementary Functions", 3rd ed., Birkhäuser 2016, chapters 5 and 6.
#pragma once

namespace transformesh::elementary {

double exp(double x);
double exp2(double x);

/// Of 0: minus infinity; of negative numbers: not a number.
double log(double x);
double log2(double x);
double log10(double x);

/// The base is at least 0, else the result is not a number; pow(x, 0) = pow(1, x) = 1. Exact where
/// a double holds the result.
double pow(double base, double exponent);
/// Exact for cubes.
double cbrt(double x);

}  // namespace transformesh::elementary
