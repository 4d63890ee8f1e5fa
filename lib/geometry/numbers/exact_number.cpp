#include "geometry/numbers/exact_number.h"

#ifndef TM_WITHOUT_GMP
#include <CGAL/Gmpq.h>
#endif

namespace transformesh {

#ifdef TM_WITHOUT_GMP

double quotient(const ExactNumber& numerator, const ExactNumber& positive_denominator) {
  return truncated_quotient(numerator, positive_denominator);
}

#else

// The fraction is not reduced first, because reducing it would take most of the time.
double quotient(const ExactNumber& numerator, const ExactNumber& positive_denominator) {
  const CGAL::Gmpq p(numerator), q(positive_denominator);
  const CGAL::Gmpz above = p.numerator() * q.denominator();
  const CGAL::Gmpz below = p.denominator() * q.numerator();
  mpq_t fraction;
  *mpq_numref(fraction) = *above.mpz();
  *mpq_denref(fraction) = *below.mpz();
  return mpq_get_d(fraction);
}

#endif

}  // namespace transformesh
