/// The error function, the same on every machine, by IEEE operations only. Errors are at most .53
/// units in the last place (ulp), and 1 ulp below 2^-400. Reference: Abramowitz & Stegun, "Handbook
/// of Mathematical Functions", 1964, 7.1.6 and 7.1.19.
#pragma once

namespace transformesh::elementary {

double erf(double x);

}  // namespace transformesh::elementary
