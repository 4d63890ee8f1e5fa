/// Balls around results of random formulas with rational exact values.
#include "geometry/numbers/wide_exponent_ball.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/rational.h"

using namespace transformesh;

namespace {

using test::Rational;

struct Both {
  WideExponentBall ball;
  Rational exact;
};

double any_number(test::Random& random, int exponents) {
  const int exponent = static_cast<int>(random.below(2 * exponents + 1)) - exponents;
  return std::ldexp(random.uniform(-1, 1), exponent);
}

/// Returns a sum of products of differences, like a determinant.
Both random_formula(test::Random& random, int exponents) {
  Both sum{WideExponentBall(0), Rational(0)};
  for (int term = 0; term < 4; ++term) {
    Both product{WideExponentBall(1), Rational(1)};
    for (int factor = 0; factor < 3; ++factor) {
      const double a = any_number(random, exponents), b = any_number(random, exponents);
      product.ball = product.ball * (WideExponentBall(a) - WideExponentBall(b));
      product.exact = product.exact * (Rational(a) - Rational(b));
    }
    sum.ball = sum.ball + product.ball;
    sum.exact = sum.exact + product.exact;
  }
  return sum;
}

int sign_of(const Rational& number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

}  // namespace

TEST_CASE("a wide ball contains the exact value, and nearly always knows its sign") {
  test::Random random(5);
  int known = 0;
  constexpr int rounds = 2000;
  for (int round = 0; round < rounds; ++round) {
    const Both result = random_formula(random, round % 2 == 0 ? 1000 : 10);
    const int sign = result.ball.sign();
    known += sign != 0 ? 1 : 0;
    if (sign != 0) CHECK(sign == sign_of(result.exact));
    if (std::isfinite(result.ball.low())) CHECK(Rational(result.ball.low()) <= result.exact);
    if (std::isfinite(result.ball.high())) CHECK(Rational(result.ball.high()) >= result.exact);
  }
  CHECK(known > rounds * 99 / 100);
}

TEST_CASE("a quotient of wide balls contains the exact quotient") {
  test::Random random(6);
  for (int round = 0; round < 500; ++round) {
    const Both a = random_formula(random, 100), b = random_formula(random, 100);
    if (b.ball.sign() == 0) continue;
    const WideExponentBall ratio = a.ball / b.ball;
    const Rational exact = a.exact / b.exact;
    CHECK(Rational(ratio.low()) <= exact);
    CHECK(Rational(ratio.high()) >= exact);
  }
}

TEST_CASE("infinite values, and zeros with an error, have no sign") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(WideExponentBall(0).sign() == 0);
  CHECK(WideExponentBall(1, 2).sign() == 0);
  CHECK(WideExponentBall(0, infinity).sign() == 0);
  CHECK((WideExponentBall(0, infinity) * WideExponentBall(0)).sign() == 0);
  CHECK((WideExponentBall(1e300) - WideExponentBall(1e300)).sign() == 0);
  CHECK((WideExponentBall(3, 1) * WideExponentBall(-2)).sign() == -1);
  CHECK((WideExponentBall(1e-300) * WideExponentBall(1e-300) - WideExponentBall(1e-320)).sign() ==
        -1);
  CHECK((WideExponentBall(1e300) * WideExponentBall(1e300) + WideExponentBall(-1e308)).sign() == 1);
  // The largest numbers, and subnormal numbers.
  CHECK(
      (WideExponentBall(1.5e308) - WideExponentBall(0.8e308) - WideExponentBall(0.6e308)).sign() ==
      1);
  CHECK(
      (WideExponentBall(1.5e308) - WideExponentBall(0.8e308) - WideExponentBall(0.8e308)).sign() ==
      -1);
  CHECK((WideExponentBall(3e-322) - WideExponentBall(2e-322)).sign() == 1);
}
