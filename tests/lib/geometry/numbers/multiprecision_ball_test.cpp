/// Balls of many digits around results of random formulas with rational exact values, and points
/// and planes constructed with them.
#include "geometry/numbers/multiprecision_ball.h"

#include <doctest/doctest.h>

#include "geometry/numbers/homogeneous.h"
#include "geometry/numbers/wide_exponent_ball.h"
#include "helpers/random.h"
#include "helpers/rational.h"

using namespace transformesh;

namespace {

using test::Rational;

struct Both {
  MultiprecisionBall ball;
  Rational exact;
};

double any_number(test::Random& random, int exponents) {
  if (random.below(8) == 0) return static_cast<double>(random.below(5)) - 2;
  const int exponent = static_cast<int>(random.below(2 * exponents + 1)) - exponents;
  return std::ldexp(random.uniform(-1, 1), exponent);
}

int sign_of(const Rational& number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

/// A random expression of sums, differences and products.
Both expression(test::Random& random, int exponents, int depth) {
  if (depth == 0) {
    const double number = any_number(random, exponents);
    return {MultiprecisionBall(number), Rational(number)};
  }
  const Both a = expression(random, exponents, depth - 1);
  const Both b = expression(random, exponents, depth - 1);
  switch (random.below(3)) {
    case 0:
      return {a.ball + b.ball, a.exact + b.exact};
    case 1:
      return {a.ball - b.ball, a.exact - b.exact};
    default:
      return {a.ball * b.ball, a.exact * b.exact};
  }
}

Vec3 any_point(test::Random& random, int exponents) {
  return {any_number(random, exponents), any_number(random, exponents),
          any_number(random, exponents)};
}

}  // namespace

TEST_CASE("signs from multiprecision balls are right, and known for nearly all that are not 0") {
  test::Random random(7);
  int told = 0, open = 0;
  for (int round = 0; round < 3000; ++round) {
    const int exponents = round % 3 == 0 ? 1000 : round % 3 == 1 ? 100 : 3;
    const Both result = expression(random, exponents, 4);
    const int sign = result.ball.sign();
    if (sign != 0) REQUIRE(sign == sign_of(result.exact));
    told += sign != 0 ? 1 : 0;
    open += sign == 0 && result.exact != 0 ? 1 : 0;
  }
  CHECK(told > 2000);
  CHECK(open < 30);
}

TEST_CASE("a sum that cancels below the last digit has no sign, above it has one") {
  const double tiny = 0x1p-300, less = 0x1p-700;
  const MultiprecisionBall one(1), almost = one + MultiprecisionBall(tiny),
                                   nearer = one + MultiprecisionBall(less);
  CHECK((almost - one).sign() == 1);
  CHECK((one - almost).sign() == -1);
  CHECK((nearer - one).sign() == 0);
  CHECK((one - nearer).sign() == 0);
  CHECK((one - one).sign() == 0);
  CHECK((almost * almost - one - MultiprecisionBall(tiny)).sign() == 1);
  // A borrow that propagates through all digits.
  CHECK((one - MultiprecisionBall(0x1p-500) - one).sign() == -1);
  CHECK((MultiprecisionBall(-1) + MultiprecisionBall(0x1p-500)).sign() == -1);
}

TEST_CASE("multiprecision balls neither over- nor underflow, and propagate the unknown") {
  MultiprecisionBall large(1e300), small(-5e-324);
  for (int i = 0; i < 20; ++i) large = large * large;
  for (int i = 0; i < 20; ++i) small = small * small;
  CHECK(large.sign() == 1);
  CHECK(small.sign() == 1);
  CHECK((large * small - MultiprecisionBall(1)).sign() == -1);
  CHECK(MultiprecisionBall(0).sign() == 0);
  CHECK(MultiprecisionBall(-0.0).sign() == 0);
  CHECK(MultiprecisionBall(HUGE_VAL).sign() == 0);
  CHECK((MultiprecisionBall(1) - MultiprecisionBall(HUGE_VAL)).sign() == 0);
  CHECK(MultiprecisionBall::unknown().sign() == 0);
  CHECK((MultiprecisionBall::unknown() + large).sign() == 0);
  CHECK((MultiprecisionBall::unknown() * large).sign() == 0);
}

TEST_CASE("homogeneous points lie on their planes and lines, by rationals") {
  test::Random random(9);
  int told = 0;
  for (int round = 0; round < 400; ++round) {
    const int exponents = round % 2 == 0 ? 480 : 4;
    std::array<Vec3, 11> p;
    for (Vec3& point : p) point = any_point(random, exponents);
    const Triangle f{p[0], p[1], p[2]}, g{p[3], p[4], p[5]}, h{p[6], p[7], p[8]};

    // Checks in exact arithmetic that points satisfy the planes, and that the point of the line is
    // on the line.
    const auto line = homogeneous_point(p[9], p[10], homogeneous_plane<Rational>(f));
    const auto corner =
        homogeneous_point(homogeneous_plane<Rational>(f), homogeneous_plane<Rational>(g),
                          homogeneous_plane<Rational>(h));
    REQUIRE(height_over(f, line) == 0);
    for (const Triangle& t : {f, g, h}) REQUIRE(height_over(t, corner) == 0);
    if (exponents == 4) {
      const auto from = number_vector<Rational>(p[9]);
      NumberVector<Rational> way;
      for (std::size_t i = 0; i < 3; ++i) way[i] = line.x[i] - from[i] * line.w;
      const auto turned = cross(way, difference<Rational>(p[10], p[9]));
      for (std::size_t i = 0; i < 3; ++i) REQUIRE(turned[i] == 0);
    }

    // Checks in balls that signs are correct, and mostly decided.
    const Rational truth = height_over(g, line);
    const auto in_balls = homogeneous_point(p[9], p[10], homogeneous_plane<MultiprecisionBall>(f));
    const int sign = height_over(g, in_balls).sign();
    if (sign != 0) REQUIRE(sign == sign_of(truth));
    const auto in_doubles = homogeneous_point(p[9], p[10], homogeneous_plane<WideExponentBall>(f));
    const int wide = height_over(g, in_doubles).sign();
    if (wide != 0) REQUIRE(wide == sign_of(truth));
    told += sign != 0 ? 1 : 0;
  }
  CHECK(told > 300);
}
