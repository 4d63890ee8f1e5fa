#include "support/elementary/arctangent.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "helpers/exact_function.h"

using namespace transformesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest_normal = std::numeric_limits<double>::min();

/// Returns the allowed error of a result; one unit if it is subnormal.
double most_units_off(double result) { return std::abs(result) < smallest_normal ? 1 : 0.56; }

/// Returns the error of an arctangent as a fraction of the allowed error.
double share_of_allowed(double x) {
  const double angle = elementary::atan(x);
  return test::units_off(angle, mpfr_atan, x) / most_units_off(angle);
}

double share_of_allowed(double y, double x) {
  const double angle = elementary::atan2(y, x);
  return test::units_off(angle, mpfr_atan2, y, x) / most_units_off(angle);
}

/// Tangents at entries of the table and between them, and those at which the axes are exchanged.
std::vector<double> seams() {
  std::vector<double> all;
  for (int i = 1; i <= 128; ++i) all.insert(all.end(), {i / 128.0, 128.0 / i});
  return all;
}

}  // namespace

TEST_CASE("errors of arctangents are within the stated bounds") {
  test::Random random(1);
  double worst = 0;
  for (int i = 0; i < 30000; ++i)
    worst = std::max(worst, share_of_allowed(test::any_number(random, -1074, 1023)));
  for (int i = 0; i < 70000; ++i)
    worst = std::max(worst, share_of_allowed(test::any_number(random, -10, 10)));
  for (const double seam : seams())
    for (const double x : test::neighborhood(seam, 5)) worst = std::max(worst, share_of_allowed(x));
  CHECK(worst <= 1);
}

TEST_CASE("errors of angles of points are within the stated bounds everywhere") {
  test::Random random(2);
  double worst = 0;
  const auto measure = [&](int low, int high, int spread) {
    const double y = test::any_number(random, low, high);
    const double x = y * test::any_number(random, -spread, spread);
    worst = std::max(worst, share_of_allowed(y, x));
  };
  for (int i = 0; i < 70000; ++i) measure(-400, 400, 6);
  for (int i = 0; i < 20000; ++i) measure(-1074, 1023, 70);
  for (int i = 0; i < 20000; ++i) {
    const double y = test::any_number(random, -1074, 1023);
    worst = std::max(worst, share_of_allowed(y, test::any_number(random, -1074, 1023)));
  }
  CHECK(worst <= 1);
}

TEST_CASE("angles of zeros, infinities and NaN are those of IEEE 754") {
  const std::array values = {0.0, -0.0, 1.0, -1.0, infinity, -infinity, std::nan("")};
  for (const double y : values)
    for (const double x : values) {
      CAPTURE(y);
      CAPTURE(x);
      CHECK(test::is_same(elementary::atan2(y, x), std::atan2(y, x)));
    }
  for (const double x : values) CHECK(test::is_same(elementary::atan(x), std::atan(x)));
}

TEST_CASE("arctangents rise across the seams of their table") {
  for (const double seam : seams()) {
    CAPTURE(seam);
    CHECK(std::ranges::is_sorted(test::neighborhood(seam, 50), {}, elementary::atan));
  }
}
