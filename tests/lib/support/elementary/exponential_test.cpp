#include "support/elementary/exponential.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "helpers/exact_function.h"

using namespace transformesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest_normal = std::numeric_limits<double>::min();

/// Returns the allowed error of a result; one unit if it is subnormal.
double most_units_off(double result) { return std::abs(result) < smallest_normal ? 1 : 0.52; }

/// Returns the error of a function as a fraction of the allowed error.
double share_of_allowed(double (*function)(double), test::ExactFunction exact, double x) {
  const double result = function(x);
  return test::units_off(result, exact, x) / most_units_off(result);
}

double share_of_power(double base, double exponent) {
  const double result = elementary::pow(base, exponent);
  return test::units_off(result, mpfr_pow, base, exponent) / most_units_off(result);
}

template <typename Argument>
double worst_of(int count, double (*function)(double), test::ExactFunction exact,
                Argument argument) {
  double worst = 0;
  for (int i = 0; i < count; ++i)
    worst = std::max(worst, share_of_allowed(function, exact, argument()));
  return worst;
}

}  // namespace

TEST_CASE("errors of exponentials are within the stated bounds") {
  test::Random random(1);
  const auto any = [&] { return test::any_number(random, -1074, 9); };
  const auto usual = [&] { return test::any_number(random, -12, 5); };
  const auto to_both_ends = [&] { return random.uniform(-746, 711); };
  const auto to_both_ends_of_2 = [&] { return random.uniform(-1080, 1025); };
  CHECK(worst_of(20000, elementary::exp, mpfr_exp, any) <= 1);
  CHECK(worst_of(40000, elementary::exp, mpfr_exp, usual) <= 1);
  CHECK(worst_of(40000, elementary::exp, mpfr_exp, to_both_ends) <= 1);
  CHECK(worst_of(20000, elementary::exp2, mpfr_exp2, any) <= 1);
  CHECK(worst_of(40000, elementary::exp2, mpfr_exp2, usual) <= 1);
  CHECK(worst_of(40000, elementary::exp2, mpfr_exp2, to_both_ends_of_2) <= 1);
}

TEST_CASE("errors of logarithms are within the stated bounds") {
  test::Random random(2);
  const auto any = [&] { return std::abs(test::any_number(random, -1074, 1023)); };
  const auto near_1 = [&] { return 1 + test::any_number(random, -52, -2); };
  const auto around_1 = [&] { return random.uniform(0.5, 2); };
  const auto measure = [&](double (*function)(double), test::ExactFunction exact) {
    return std::max({worst_of(40000, function, exact, any),
                     worst_of(30000, function, exact, near_1),
                     worst_of(30000, function, exact, around_1)});
  };
  CHECK(measure(elementary::log, mpfr_log) <= 1);
  CHECK(measure(elementary::log2, mpfr_log2) <= 1);
  CHECK(measure(elementary::log10, mpfr_log10) <= 1);
}

TEST_CASE("errors of powers and cube roots are within the stated bounds") {
  test::Random random(3);
  double worst = 0;
  for (int i = 0; i < 30000; ++i) {
    const double base = std::abs(test::any_number(random, -1074, 1023));
    worst = std::max(worst, share_of_power(base, test::any_number(random, -20, 10)));
  }
  for (int i = 0; i < 30000; ++i)
    worst = std::max(worst, share_of_power(random.uniform(0.01, 100), random.uniform(-5, 5)));
  // Bases near 1 and large results are the most difficult cases.
  for (int i = 0; i < 40000; ++i) {
    const double base = 1 + test::any_number(random, -45, -2);
    worst = std::max(worst, share_of_power(base, random.uniform(-745, 710) / std::log(base)));
  }
  CHECK(worst <= 1);
  const auto any = [&] { return test::any_number(random, -1074, 1023); };
  CHECK(worst_of(100000, elementary::cbrt, mpfr_cbrt, any) <= 1);
}

TEST_CASE("powers, logarithms and roots that are doubles are exact") {
  for (int i = -1074; i < 1024; ++i) {
    const double power = std::ldexp(1, i);
    CAPTURE(i);
    CHECK(elementary::exp2(i) == power);
    CHECK(elementary::pow(2, i) == power);
    CHECK(elementary::log2(power) == i);
  }
  double power_of_10 = 1;
  for (int i = 0; i <= 22; ++i, power_of_10 *= 10) {
    CHECK(elementary::log10(power_of_10) == i);
    CHECK(elementary::pow(10, i) == power_of_10);
  }
  for (double i = 1; i < 200000; i += 37) {
    CAPTURE(i);
    CHECK(elementary::cbrt(i * i * i) == i);
    CHECK(elementary::cbrt(-i * i * i) == -i);
    CHECK(elementary::pow(i, 3) == i * i * i);
    CHECK(elementary::pow(i * i, 0.5) == i);
    CHECK(elementary::pow(i, 1) == i);
  }
}

TEST_CASE("exponentials of zeros, infinities and NaN are those of IEEE 754") {
  const double none = std::nan("");
  CHECK(elementary::exp(0) == 1);
  for (const auto function : {elementary::exp, elementary::exp2}) {
    CHECK(function(infinity) == infinity);
    CHECK(test::is_same(function(-infinity), 0));
    CHECK(std::isnan(function(none)));
  }
  for (const auto function : {elementary::log, elementary::log2, elementary::log10}) {
    CHECK(test::is_same(function(1), 0));
    CHECK(function(0) == -infinity);
    CHECK(function(-0.0) == -infinity);
    CHECK(function(infinity) == infinity);
    for (const double x : {-1.0, -infinity, none}) CHECK(std::isnan(function(x)));
  }
  for (const double x : {0.0, -0.0, infinity, -infinity, none})
    CHECK(test::is_same(elementary::cbrt(x), x));
}

TEST_CASE("powers of zeros, infinities and NaN are those of IEEE 754") {
  const double none = std::nan("");
  for (const double base : {0.0, 0.5, 1.0, 2.0, infinity, none})
    for (const double exponent : {-infinity, -2.0, -0.0, 0.0, 2.0, infinity, none}) {
      CAPTURE(base);
      CAPTURE(exponent);
      CHECK(test::is_same(elementary::pow(base, exponent), std::pow(base, exponent)));
    }
  CHECK(std::isnan(elementary::pow(-2, 2)));
}

TEST_CASE("exponentials and logarithms rise across the seams of their tables") {
  for (int i = -200; i <= 200; ++i) {
    CAPTURE(i);
    const auto rises = [&](double (*function)(double), double seam) {
      return std::ranges::is_sorted(test::neighborhood(seam, 50), {}, function);
    };
    CHECK(rises(elementary::exp, i * std::numbers::ln2 / 128));
    CHECK(rises(elementary::exp2, i / 128.0));
    const double center = 1 + i / 512.0;
    CHECK(rises(elementary::log, center));
    CHECK(rises(elementary::log2, center));
    CHECK(rises(elementary::log10, center));
    CHECK(rises(elementary::cbrt, center));
  }
  const double root = std::numbers::sqrt2;
  CHECK(std::ranges::is_sorted(test::neighborhood(root, 50), {}, elementary::log));
}
