/// Sines, cosines and tangents that are the same on every machine, by IEEE operations only; results
/// of libm differ between processors in the last digit. Errors are at most .55 units in the last
/// place, for arguments of any size. Results are NaN for arguments that are not finite. References:
/// Cody & Waite, "Software Manual for the Elementary Functions", Prentice-Hall 1980; Payne & Hanek,
/// "Radian reduction for trigonometric functions", SIGNUM Newsletter 18, 1983; Muller, "Elementary
/// Functions", 3rd ed., Birkhäuser 2016, chapters 6 and 11.
#pragma once

namespace transformesh::elementary {

double sin(double x);
double cos(double x);
double tan(double x);

}  // namespace transformesh::elementary
