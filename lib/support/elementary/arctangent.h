/// Arctangents that are the same on every machine, by IEEE operations alone: those of libm differ
/// in the last digit from processor to processor.
/// Errors are at most .56 units in the last place, and one where a result is subnormal.
/// References: Tang, "Table-lookup algorithms for elementary functions and their error analysis",
/// ARITH 10, 1991; Muller, "Elementary Functions", 3rd ed., Birkhäuser 2016, chapter 6.
#pragma once

namespace transformesh::elementary {

double atan(double x);

/// The angle of the point (x, y), in [-pi, pi]; of zeros and infinities, as IEEE 754 has it.
double atan2(double y, double x);

}  // namespace transformesh::elementary
