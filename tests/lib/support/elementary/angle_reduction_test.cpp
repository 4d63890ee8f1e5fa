#include "support/elementary/angle_reduction.h"

#include <doctest/doctest.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/exact_function.h"

using namespace transformesh;

namespace {

/// Reduces angles with enough digits for the largest doubles.
class ExactReduction {
 public:
  ExactReduction() {
    mpfr_inits2(1400, quarter_, rest_, quarters_, nullptr);
    mpfr_const_pi(quarter_, MPFR_RNDN);
    mpfr_div_2ui(quarter_, quarter_, 1, MPFR_RNDN);
  }
  ExactReduction(const ExactReduction&) = delete;
  ExactReduction& operator=(const ExactReduction&) = delete;
  ~ExactReduction() { mpfr_clears(quarter_, rest_, quarters_, nullptr); }

  /// Returns the error of the angle computed from the quadrant and the rest, relative to the rest.
  double relative_error(double x, const elementary::ReducedAngle& angle) {
    mpfr_set_d(quarters_, x, MPFR_RNDN);
    mpfr_div(quarters_, quarters_, quarter_, MPFR_RNDN);
    mpfr_sub_d(rest_, quarters_, angle.quarters, MPFR_RNDN);
    mpfr_div_2ui(rest_, rest_, 2, MPFR_RNDN);
    mpfr_rint(rest_, rest_, MPFR_RNDN);
    mpfr_mul_2ui(rest_, rest_, 2, MPFR_RNDN);
    mpfr_sub(rest_, quarters_, rest_, MPFR_RNDN);
    mpfr_sub_d(rest_, rest_, angle.quarters, MPFR_RNDN);
    mpfr_mul(rest_, rest_, quarter_, MPFR_RNDN);
    mpfr_sub_d(rest_, rest_, angle.rest.high, MPFR_RNDN);
    mpfr_sub_d(rest_, rest_, angle.rest.low, MPFR_RNDN);
    return std::abs(mpfr_get_d(rest_, MPFR_RNDN) / angle.rest.high);
  }

 private:
  mpfr_t quarter_, rest_, quarters_;
};

}  // namespace

TEST_CASE("an angle is quarter turns and a rest, to 60 bits of the rest") {
  ExactReduction exact;
  test::Random random(1);
  double error = 0;
  double largest = 0;
  const auto reduce = [&](double x) {
    const elementary::ReducedAngle angle = elementary::reduced_angle(x);
    REQUIRE(angle.quarters >= 0);
    REQUIRE(angle.quarters < 4);
    error = std::max(error, exact.relative_error(x, angle));
    largest = std::max(largest, std::abs(angle.rest.high));
  };
  for (int i = 0; i < 20000; ++i) reduce(test::any_number(random, -20, 1023));
  for (int i = 0; i < 20000; ++i) reduce(test::any_number(random, 0, 22));
  for (int i = 1; i < 5000; ++i)
    for (const double x : test::neighborhood(i * (std::numbers::pi / 2), 1)) reduce(x);
  // The double nearest to a multiple of pi/2, and the numbers at which another method is used.
  reduce(0x1.6ac5b262ca1ffp+849);
  for (const double x : test::neighborhood(0x1p20, 3)) reduce(x);
  CHECK(error <= 0x1p-60);
  CHECK(largest <= std::numbers::pi / 4 * (1 + 0x1p-30));
}
