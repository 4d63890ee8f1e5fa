/// Signs of sums of products of doubles of any magnitude, compared with Boost's rationals.
#include "geometry/numbers/monomial_sum.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "helpers/random.h"
#include "helpers/rational.h"

using namespace transformesh;

namespace {

using test::Rational;

/// A sum of products, and the same sum in rationals.
class BothSums {
 public:
  void add(double a, double b, double c, bool is_added) {
    const BinaryDigits x(a), y(b), z(c);
    is_added ? sum_.add(x, y, z) : sum_.subtract(x, y, z);
    const Rational product = Rational(a) * Rational(b) * Rational(c);
    exact_ += is_added ? product : Rational(-product);
  }
  void check() const { REQUIRE(sum_.sign() == exact_.sign()); }
  bool is_zero() const { return exact_ == 0; }

 private:
  MonomialSum sum_;
  Rational exact_ = 0;
};

double number_up_to(test::Random& random, int exponents) {
  if (random.below(12) == 0) return 0;
  const int exponent = static_cast<int>(random.below(2 * exponents + 1)) - exponents;
  return std::ldexp(random.uniform(-1, 1), exponent);
}

}  // namespace

TEST_CASE("a sum of products has the sign of rational arithmetic, for all magnitudes") {
  test::Random random(21);
  for (int round = 0; round < 4000; ++round) {
    const int exponents = std::array{0, 20, 150, 1000}[random.below(4)];
    BothSums sum;
    for (std::size_t i = 1 + random.below(MonomialSum::most); i > 0; --i)
      sum.add(number_up_to(random, exponents), number_up_to(random, exponents),
              number_up_to(random, exponents), random.below(2) == 0);
    sum.check();
  }
}

// The large terms cancel, in another order and with other factors. The rest is hundreds of powers
// of two smaller, or zero.
TEST_CASE("canceling terms leave the sign of much smaller ones, or zero") {
  test::Random random(22);
  int zeros = 0;
  for (int round = 0; round < 4000; ++round) {
    BothSums sum;
    for (std::size_t i = 0; i < MonomialSum::most / 4; ++i) {
      const double a = number_up_to(random, 300), b = number_up_to(random, 300),
                   c = number_up_to(random, 300);
      sum.add(a, b, c, true);
      sum.add(std::ldexp(c, 7), a, std::ldexp(b, -7), false);
    }
    const int rest = static_cast<int>(random.below(4));
    for (int i = 0; i < rest; ++i)
      sum.add(number_up_to(random, 20), number_up_to(random, 20), std::ldexp(1, -900),
              random.below(2) == 0);
    sum.check();
    zeros += sum.is_zero() ? 1 : 0;
  }
  CHECK(zeros > 900);
}

// Factors differ by one unit in the last place, so that products nearly cancel and each window
// passes a carry on to the next.
TEST_CASE("carries of nearly canceling terms propagate through the windows") {
  test::Random random(23);
  for (int round = 0; round < 2000; ++round) {
    BothSums sum;
    for (int k = 0; k < 8; ++k) {
      const double size = std::ldexp(random.uniform(1, 2), 900 - 210 * k);
      const double next = std::nextafter(size, 0);
      sum.add(size, size, 1, true);
      sum.add(next, std::nextafter(size, std::numeric_limits<double>::infinity()), 1, false);
      sum.add(size, 1, std::ldexp(random.uniform(-1, 1), -static_cast<int>(random.below(300))),
              true);
    }
    sum.check();
  }
}

TEST_CASE("the smallest and the largest doubles count") {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  constexpr double most = std::numeric_limits<double>::max();
  BothSums sum;
  sum.check();
  sum.add(most, most, most, true);
  sum.add(-most, most, most, true);
  sum.check();
  sum.add(least, -least, 3 * least, true);
  sum.check();
  sum.add(least, least, least, true);
  sum.add(least, 2 * least, least, true);
  sum.check();
}
