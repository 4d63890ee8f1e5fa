#include "support/elementary/trigonometric.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "helpers/exact_function.h"

using namespace transformesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_units_off = 0.55;

/// Random numbers, numbers within a few turns, and numbers nearest to multiples of pi/4.
std::vector<double> angles() {
  test::Random random(1);
  std::vector<double> all;
  for (int i = 0; i < 30000; ++i) all.push_back(test::any_number(random, -1074, 1023));
  for (int i = 0; i < 70000; ++i) all.push_back(test::any_number(random, -30, 25));
  for (int i = 0; i < 2000; ++i)
    for (const double x : test::neighborhood(i * (std::numbers::pi / 4), 2)) all.push_back(x);
  for (int i = -1074; i < 1024; ++i) all.push_back(std::ldexp(1, i));
  // The double that is nearest to a multiple of pi/2, and the largest double.
  all.insert(all.end(), {0x1.6ac5b262ca1ffp+849, std::numeric_limits<double>::max()});
  return all;
}

double worst(double (*function)(double), test::ExactFunction exact) {
  double units = 0;
  for (const double x : angles()) units = std::max(units, test::units_off(function(x), exact, x));
  return units;
}

/// Numbers at which another entry of the table is used, and numbers between them.
std::vector<double> seams() {
  std::vector<double> all = {std::numbers::pi / 4};
  for (int i = 1; i < 52; ++i) all.push_back(i / 64.0);
  return all;
}

bool is_increasing(double (*function)(double), double sign) {
  return std::ranges::all_of(seams(), [&](double seam) {
    const std::vector<double> around = test::neighborhood(seam, 50);
    return std::ranges::is_sorted(
        around, [&](double a, double b) { return sign * function(a) < sign * function(b); });
  });
}

}  // namespace

TEST_CASE("errors of sines, cosines and tangents are within the stated bounds") {
  CHECK(worst(elementary::sin, mpfr_sin) <= most_units_off);
  CHECK(worst(elementary::cos, mpfr_cos) <= most_units_off);
  CHECK(worst(elementary::tan, mpfr_tan) <= most_units_off);
}

TEST_CASE("sines of zeros, infinities and NaN are those of IEEE 754") {
  for (const auto function : {elementary::sin, elementary::tan}) {
    CHECK(test::is_same(function(0), 0));
    CHECK(test::is_same(function(-0.0), -0.0));
  }
  CHECK(elementary::cos(-0.0) == 1);
  for (const auto function : {elementary::sin, elementary::cos, elementary::tan})
    for (const double x : {infinity, -infinity, std::nan("")}) CHECK(std::isnan(function(x)));
}

TEST_CASE("sines are odd and cosines even, to the last digit") {
  test::Random random(2);
  bool are_symmetric = true;
  for (int i = 0; i < 10000; ++i) {
    const double x = test::any_number(random, -30, 1023);
    are_symmetric = are_symmetric && elementary::sin(-x) == -elementary::sin(x) &&
                    elementary::cos(-x) == elementary::cos(x) &&
                    elementary::tan(-x) == -elementary::tan(x);
  }
  CHECK(are_symmetric);
}

TEST_CASE("sines and tangents rise and cosines fall across the seams of their table") {
  CHECK(is_increasing(elementary::sin, 1));
  CHECK(is_increasing(elementary::cos, -1));
  CHECK(is_increasing(elementary::tan, 1));
}
