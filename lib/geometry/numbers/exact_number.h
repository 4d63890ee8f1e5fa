/// Type of exact numbers, which decide a sign if faster types fail. It is CGAL's Mpzf, which needs
/// GMP, or DyadicNumber in builds without GMP. Both represent every finite double, and all sums and
/// products of finite doubles.
#pragma once

#ifdef TM_WITHOUT_GMP
#include "geometry/numbers/dyadic_number.h"
#else
#include <CGAL/Mpzf.h>
#endif

namespace transformesh {

using ExactNumber =
#ifdef TM_WITHOUT_GMP
    DyadicNumber;
#else
    CGAL::Mpzf;
#endif

inline int sign_of(const ExactNumber& number) { return static_cast<int>(sign(number)); }

/// Returns the quotient, rounded towards 0.
double quotient(const ExactNumber& numerator, const ExactNumber& positive_denominator);

}  // namespace transformesh
