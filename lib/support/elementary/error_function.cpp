#include "support/elementary/error_function.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "support/elementary/double_double.h"

namespace transformesh::elementary {
namespace {

constexpr int steps_per_unit = 8;    ///< number of table intervals per unit
constexpr double limit = 6;          ///< erf(x) rounds to 1 for larger x
constexpr int last_error_step = 48;  ///< index of the last table entry, at the limit

constexpr DoubleDouble two_over_root_of_pi{0x1.20dd750429b6dp+0, 0x1.1ae3a914fed80p-56};

struct Entry {
  DoubleDouble value;
  DoubleDouble derivative;
};

/// Returns exp(x) for -2 < x < 0.
constexpr DoubleDouble decay(double x) {
  DoubleDouble sum = one;
  for (int n = 30; n > 0; --n) sum = one + sum * x / n;
  return sum;
}

/// Returns the ratio of erf to its derivative, by a series of positive terms.
constexpr DoubleDouble ratio_to_derivative(double x) {
  DoubleDouble term{x, 0};
  DoubleDouble sum = term;
  for (int n = 1; term.high > sum.high * 0x1p-110; ++n) {
    term = term * (2 * x * x) / (2 * n + 1);
    sum = sum + term;
  }
  return sum;
}

/// Entry j contains erf(x) and its derivative at x = j/8. The derivative is exp(-j^2/64) times the
/// derivative at 0. It is computed from the derivative in the previous entry.
constexpr auto error_table = [] {
  std::array<Entry, last_error_step + 1> entries;
  entries[0].derivative = two_over_root_of_pi;
  for (int j = 1; j <= last_error_step; ++j) {
    entries[j].derivative = entries[j - 1].derivative * decay((1.0 - 2 * j) / 64);
    entries[j].value = ratio_to_derivative(1.0 * j / steps_per_unit) * entries[j].derivative;
  }
  return entries;
}();

/// Returns the integral of exp(-2 center t - t^2) - 1 over t from 0 to x, by its Taylor series.
double rest_of_integral(double center, double x) {
  double before = 1;
  double coefficient = -2 * center;
  double power = x * x;
  double sum = 0;
  for (int n = 2; n <= 18; ++n) {
    sum += coefficient * power / n;
    const double next = -2 * (center * coefficient + before) / n;
    before = coefficient;
    coefficient = next;
    power *= x;
  }
  return sum;
}

double erf_of_positive(double x) {
  const double step = nearest_integer(x * steps_per_unit);
  const double center = step / steps_per_unit;
  const auto& [value, derivative] = error_table[static_cast<std::size_t>(step)];
  const DoubleDouble integral = fast_sum(x - center, rest_of_integral(center, x - center));
  return (value + derivative * integral).value();
}

}  // namespace

double erf(double x) {
  const double size = std::abs(x);
  if (std::isnan(x)) return std::numeric_limits<double>::quiet_NaN();
  if (size < 0x1p-400) return x * two_over_root_of_pi.high + x * two_over_root_of_pi.low;
  return std::copysign(size < limit ? erf_of_positive(size) : 1, x);
}

}  // namespace transformesh::elementary
