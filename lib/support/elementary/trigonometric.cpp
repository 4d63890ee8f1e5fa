#include "support/elementary/trigonometric.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "support/elementary/angle_reduction.h"

namespace transformesh::elementary {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double negligible = 0x1p-27;  ///< sin(x) and tan(x) round to x if |x| is smaller

constexpr int steps_per_radian = 32;  ///< number of table intervals per radian
constexpr int last_sine_step = 26;    ///< index of the last table entry, just above pi/4

struct SineAndCosine {
  DoubleDouble sine;
  DoubleDouble cosine;
};

/// Returns the sum over k of (-x^2)^k n! / (n + 2k)!.
constexpr DoubleDouble alternating_series(const DoubleDouble& x, int n) {
  DoubleDouble sum = one;
  for (int k = n + 30; k > n; k -= 2) sum = one + -(x * x * sum) / (1.0 * k * (k - 1));
  return sum;
}

constexpr auto sine_table = [] {
  std::array<SineAndCosine, last_sine_step + 1> entries;
  for (int j = 0; j <= last_sine_step; ++j) {
    const DoubleDouble x{1.0 * j / steps_per_radian, 0};
    entries[j] = {x * alternating_series(x, 1), alternating_series(x, 0)};
  }
  return entries;
}();

// Returns sine and cosine by addition formulas from the nearest angle of the table. The main terms
// of a sine (table entry and difference) are added exactly, so that small sines keep their digits.
SineAndCosine of_positive(const DoubleDouble& x) {
  const double step = nearest_integer(x.high * steps_per_radian);
  const auto& [sine, cosine] = sine_table[static_cast<std::size_t>(step)];
  const double angle = x.high - step / steps_per_radian;
  const double square = angle * angle;
  const double sine_rest =
      x.low + angle * square * (inverse(-6) + square * (inverse(120) - square * inverse(5040)));
  const double cosine_less_1 =
      square * square * (inverse(24) - square * inverse(720)) - square / 2 - angle * x.low;

  const DoubleDouble first = fast_sum(sine.high, angle);
  const double sine_low =
      sine.low + cosine.low * angle + cosine.high * sine_rest + sine.high * cosine_less_1;
  const double cosine_low =
      cosine.low - sine.low * angle - sine.high * sine_rest + cosine.high * cosine_less_1;
  return {fast_sum(first.high, first.low + ((cosine.high - 1) * angle + sine_low)),
          fast_sum(cosine.high, cosine_low - sine.high * angle)};
}

/// Returns sine and cosine of an angle of magnitude at most pi/4, up to rounding.
SineAndCosine of_reduced(const DoubleDouble& x) {
  const SineAndCosine both = of_positive(x.high < 0 ? -x : x);
  return {x.high < 0 ? -both.sine : both.sine, both.cosine};
}

SineAndCosine of_angle(double x) {
  const ReducedAngle angle = reduced_angle(x);
  const auto [sine, cosine] = of_reduced(angle.rest);
  switch (angle.quarters) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return undefined;
  return std::abs(x) < negligible ? x : of_angle(x).sine.value();
}

double cos(double x) { return std::isfinite(x) ? of_angle(x).cosine.value() : undefined; }

double tan(double x) {
  if (!std::isfinite(x)) return undefined;
  if (std::abs(x) < negligible) return x;
  const auto [sine, cosine] = of_angle(x);
  return (sine / cosine).value();
}

}  // namespace transformesh::elementary
