#include "support/elementary/error_function.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "helpers/exact_function.h"

using namespace transformesh;

namespace {

/// Returns the error of a value as a fraction of the allowed error.
double share_of_allowed(double x) {
  const double allowed = std::abs(x) < 0x1p-400 ? 1 : 0.53;
  return test::units_off(elementary::erf(x), mpfr_erf, x) / allowed;
}

}  // namespace

TEST_CASE("errors of the error function are within the stated bounds") {
  test::Random random(1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i)
    worst = std::max(worst, share_of_allowed(test::any_number(random, -1074, 3)));
  for (int i = 0; i < 20000; ++i)
    worst = std::max(worst, share_of_allowed(test::any_number(random, -60, 2)));
  for (int i = 0; i < 60000; ++i) worst = std::max(worst, share_of_allowed(random.uniform(-6, 6)));
  for (int i = 1; i <= 96; ++i)
    for (const double x : test::neighborhood(i / 16.0, 5))
      worst = std::max(worst, share_of_allowed(x));
  CHECK(worst <= 1);
}

TEST_CASE("the error function of zeros, infinities and NaN is that of C") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(test::is_same(elementary::erf(0), 0));
  CHECK(test::is_same(elementary::erf(-0.0), -0.0));
  CHECK(elementary::erf(infinity) == 1);
  CHECK(elementary::erf(-infinity) == -1);
  CHECK(elementary::erf(1e300) == 1);
  CHECK(std::isnan(elementary::erf(std::nan(""))));
}

TEST_CASE("the error function rises across the seams of its table") {
  for (int i = 1; i <= 96; ++i) {
    CAPTURE(i);
    CHECK(std::ranges::is_sorted(test::neighborhood(i / 16.0, 50), {}, elementary::erf));
  }
}
