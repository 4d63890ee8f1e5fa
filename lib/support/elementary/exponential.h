/// Exponentials and logarithms that are the same on every machine, by IEEE operations only; results
/// of libm differ between processors in the last digit. Errors are at most .52 units in the last
/// place (ulp), and 1 ulp for subnormal results. References: Tang, "Table-driven implementation of
/// the exponential function in IEEE floating-point arithmetic", ACM TOMS 15, 1989; Tang,
/// "Table-driven implementation of the logarithm function in IEEE floating-point arithmetic", ACM
/// TOMS 16, 1990; Muller, "Elementary Functions", 3rd ed., Birkhäuser 2016, chapters 5 and 6.
#pragma once

namespace transformesh::elementary {

double exp(double x);
double exp2(double x);

/// Logarithms of 0 are minus infinity; logarithms of negative numbers are NaN.
double log(double x);
double log2(double x);
double log10(double x);

/// Returns base^exponent, or NaN if the base is negative; pow(x, 0) = pow(1, x) = 1. The result is
/// exact if a double can represent it.
double pow(double base, double exponent);
/// Returns the cube root. The result is exact for cubes of doubles.
double cbrt(double x);

}  // namespace transformesh::elementary
