/// Exact numbers of builds without GMP, compared with Boost's rationals and the quotients of GMP.
#include "geometry/numbers/dyadic_number.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/numbers/exact_number.h"
#include "helpers/random.h"
#include "helpers/rational.h"

using namespace transformesh;

namespace {

using test::Rational;

/// Returns a number from denormal to huge, with few or many digits.
double some_double(test::Random& random) {
  const auto digits = static_cast<double>(random.below(std::uint64_t{1} << (1 + random.below(53))));
  const double size = std::ldexp(digits, static_cast<int>(random.below(1000)) - 560);
  return random.below(2) == 0 ? size : -size;
}

int sign_of(const Rational& number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

/// Returns a sum of products, for any number type.
template <class Number>
Number determinant(double a, double b, double c, double d) {
  return Number(a) * Number(b) - Number(c) * Number(d) + Number(a) * Number(c) * Number(d);
}

double third(double number) { return truncated_quotient(DyadicNumber(number), DyadicNumber(3)); }

}  // namespace

TEST_CASE("signs of sums of products are those of rationals") {
  test::Random random(5);
  for (int round = 0; round < 5000; ++round) {
    const double a = some_double(random), b = some_double(random), c = some_double(random),
                 d = some_double(random);
    CHECK(determinant<DyadicNumber>(a, b, c, d).sign() ==
          sign_of(determinant<Rational>(a, b, c, d)));
    CHECK((DyadicNumber(a) - DyadicNumber(a)).sign() == 0);
  }
}

TEST_CASE("quotients are those of GMP to the last bit") {
  test::Random random(6);
  for (int round = 0; round < 5000; ++round) {
    const double a = some_double(random), b = some_double(random), c = some_double(random);
    const double size = std::abs(some_double(random)) + 0x1p-1074;
    const double own = truncated_quotient(determinant<DyadicNumber>(a, b, c, size),
                                          DyadicNumber(size) * DyadicNumber(3.0));
    const double of_gmp =
        quotient(determinant<ExactNumber>(a, b, c, size), ExactNumber(size) * ExactNumber(3.0));
    // GMP does not define quotients beyond the largest double.
    if (std::isfinite(own) && std::isfinite(of_gmp)) CHECK(own == of_gmp);
  }
}

TEST_CASE("quotients are rounded towards 0") {
  CHECK(third(0) == 0);
  CHECK(third(6) == 2);
  CHECK(third(5) == std::nextafter(5.0 / 3, 0));
  CHECK(third(-5) == -std::nextafter(5.0 / 3, 0));
}

TEST_CASE("denormal quotients are rounded towards 0") {
  CHECK(third(0x1p-1073) == 0);
  CHECK(third(0x1p-1072) == 0x1p-1074);
  CHECK(third(0x5p-1074) == 0x1p-1074);
}
