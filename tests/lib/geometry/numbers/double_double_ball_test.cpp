/// Signs by balls of doubles, compared with rationals.
#include "geometry/numbers/double_double_ball.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "helpers/random.h"

using namespace transformesh;

namespace {

using Rational = boost::multiprecision::cpp_rational;

int sign_of(const Rational& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// Returns a number with a random exponent; some numbers have few digits.
double some_number(test::Random& random, int exponents) {
  const double mantissa =
      random.below(4) == 0 ? static_cast<double>(random.below(5)) - 2 : random.uniform(-1, 1);
  const auto shift = static_cast<int>(random.below(static_cast<std::uint64_t>(2 * exponents + 1)));
  return std::ldexp(mantissa, shift - exponents);
}

}  // namespace

TEST_CASE("quotients are rounded towards 0, or unknown if they are too close to a double") {
  test::Random random(4);
  int known = 0;
  for (int i = 0; i < 20000; ++i) {
    const int exponents = i % 2 == 0 ? 3 : 130;
    const double a = some_number(random, exponents), b = some_number(random, exponents);
    const double c = some_number(random, exponents);
    if (c == 0) continue;
    const auto rounded =
        (DoubleDoubleBall(a) * DoubleDoubleBall(b) / DoubleDoubleBall(c)).truncated();
    if (!rounded) continue;
    ++known;
    const Rational truth = abs(Rational(a) * Rational(b) / Rational(c));
    const double size = std::abs(*rounded);
    REQUIRE(Rational(size) <= truth);
    REQUIRE(Rational(std::nextafter(size, HUGE_VAL)) > truth);
    REQUIRE((*rounded == 0 ||
             sign_of(Rational(a) * Rational(b) * Rational(c)) == (*rounded > 0 ? 1 : -1)));
  }
  CHECK(known > 10000);
  CHECK(!DoubleDoubleBall::unknown().truncated());
  CHECK(DoubleDoubleBall(0.1).truncated() == 0.1);
  const DoubleDoubleBall one(1), tiny(0x1p-80);
  CHECK((one + tiny).truncated() == 1);
  CHECK((one - tiny).truncated() == std::nextafter(1, 0));
  CHECK((tiny - one).truncated() == -std::nextafter(1, 0));
}

TEST_CASE("signs from balls are right, and known for all but the closest cases") {
  test::Random random(3);
  int told = 0, near = 0;
  for (int i = 0; i < 20000; ++i) {
    const int exponents = i % 2 == 0 ? 20 : 130;
    const double a = some_number(random, exponents), b = some_number(random, exponents);
    const double c = some_number(random, exponents), d = some_number(random, exponents);
    // In half of the cases, (a b + c) / d - e is nearly 0, because e is the quotient in doubles.
    const double e = i % 4 < 2 ? (a * b + c) / d : some_number(random, exponents);
    if (d == 0 || !std::isfinite(e)) continue;
    const Rational truth = (Rational(a) * Rational(b) + Rational(c)) / Rational(d) - Rational(e);
    const DoubleDoubleBall ball =
        (DoubleDoubleBall(a) * DoubleDoubleBall(b) + DoubleDoubleBall(c)) / DoubleDoubleBall(d) -
        DoubleDoubleBall(e);
    if (ball.sign() != 0) REQUIRE(ball.sign() == sign_of(truth));
    const Rational size =
        (abs(Rational(a) * Rational(b)) + abs(Rational(c))) / abs(Rational(d)) + abs(Rational(e));
    const bool is_clear =
        abs(truth) * Rational(std::ldexp(1.0, 90)) > size && size > Rational(1e-200);
    if (is_clear) REQUIRE(ball.sign() == sign_of(truth));
    told += ball.sign() != 0 ? 1 : 0;
    near += is_clear && abs(truth) * Rational(std::ldexp(1.0, 50)) < size ? 1 : 0;
  }
  CHECK(told > 15000);
  CHECK(near > 2000);
}

TEST_CASE("balls beyond the range have no sign, and 0 has sign 0") {
  const DoubleDoubleBall huge(1e200), tiny(1e-200), one(1);
  CHECK((huge * huge).sign() == 0);
  CHECK((tiny * tiny).sign() == 0);
  CHECK((one / tiny).sign() == 0);
  CHECK((one - one).sign() == 0);
  CHECK((one * DoubleDoubleBall() + one).sign() == 1);
  CHECK(DoubleDoubleBall::unknown().sign() == 0);
  CHECK((DoubleDoubleBall::unknown() + one).sign() == 0);
}
