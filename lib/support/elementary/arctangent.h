/// Arctangents that are the same on every machine, by IEEE operations only; results of libm differ
/// between processors in the last digit. Errors are at most .56 units in the last place (ulp), and
/// 1 ulp for subnormal results. References: Tang, "Table-lookup algorithms for elementary functions
/// and their error analysis", ARITH 10, 1991; Muller, "Elementary Functions", 3rd ed., Birkhäuser
/// 2016, chapter 6.
#pragma once

namespace transformesh::elementary {

double atan(double x);

/// Returns the angle of the point (x, y), in [-pi, pi]; as in IEEE 754 for zeros and infinities.
double atan2(double y, double x);

}  // namespace transformesh::elementary
