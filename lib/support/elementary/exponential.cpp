#include "support/elementary/exponential.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "support/elementary/double_double.h"

namespace transformesh::elementary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

constexpr int steps_per_octave = 64;          ///< number of table intervals from 1 to 2
constexpr double largest_argument = 709.79;   ///< exp(x) overflows for larger x
constexpr double smallest_argument = -745.2;  ///< exp(x) rounds to 0 for smaller x

constexpr DoubleDouble exp_series(const DoubleDouble& x) {
  DoubleDouble sum = one;
  for (int n = 24; n > 0; --n) sum = one + x * sum / n;
  return sum;
}

/// Entry j is 2^(j/64).
constexpr auto roots_of_2 = [] {
  std::array<DoubleDouble, steps_per_octave> table;
  for (int j = 0; j < steps_per_octave; ++j)
    table[j] = exp_series(log_of_2 * (1.0 * j / steps_per_octave));
  return table;
}();

/// Returns 2^exponent times the value; rounds subnormal results.
double scaled(double value, int exponent) {
  if (exponent < -1000 || exponent > 1000) return std::ldexp(value, exponent);
  return value * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

/// Returns 2^(n/64) exp(x) for |x| <= log(2)/128.
double scaled_exp(int n, double x) {
  const double rest =
      x + x * x *
              (inverse(2) +
               x * (inverse(6) + x * (inverse(24) + x * (inverse(120) + x * inverse(720)))));
  const int step = ((n % steps_per_octave) + steps_per_octave) % steps_per_octave;
  const DoubleDouble& root = roots_of_2[step];
  return scaled(root.high + (root.low + root.high * rest), (n - step) / steps_per_octave);
}

double exp_of(const DoubleDouble& x) {
  if (std::isnan(x.high)) return not_a_number;
  if (x.high > largest_argument) return infinity;
  if (x.high < smallest_argument) return 0;
  // The product of n and the first 36 bits of log(2)/64 is exact.
  const double n = nearest_integer(x.high * (steps_per_octave * inverse(log_of_2.high)));
  const double first = x.high - n * 0x1.62e42fefa0000p-7;
  return scaled_exp(static_cast<int>(n), first + (x.low - n * 0x1.cf79abc9e3b3ap-46));
}

/// Number of table intervals between 1 and 2; interval i is centered at i / 128.
constexpr int pieces = 128;
constexpr int first_piece = 90;  ///< index of the interval that contains the square root of 1/2
/// Index of the last table interval, just above the square root of 2.
constexpr int last_piece = 182;

/// Table entry for one interval of arguments. `factor` is approximately the inverse of the
/// interval's center, rounded to a multiple of 1/1024. `log` is minus the logarithm of `factor`.
struct Inverse {
  double factor = 1;
  DoubleDouble log;
};

/// Computes log(x) by the series of the inverse hyperbolic tangent.
constexpr DoubleDouble log_series(double x) {
  const DoubleDouble z = DoubleDouble{x - 1, 0} / (x + 1);
  DoubleDouble sum;
  for (int n = 45; n > 0; n -= 2) sum = sum * (z * z) + one / n;
  return z * sum * 2;
}

constexpr auto inverses = [] {
  std::array<Inverse, last_piece - first_piece + 1> table;
  for (int i = first_piece; i <= last_piece; ++i) {
    const double factor = nearest_integer(1024.0 * pieces / i) / 1024;
    table[i - first_piece] = {factor, -log_series(factor)};
  }
  return table;
}();

/// Returns log(1 + x) for |x| < 2^-7.
DoubleDouble log_near_1(const DoubleDouble& x) {
  const double r = x.high;
  const DoubleDouble square = exact_product(r, r);
  const double late = inverse(7) - r * (inverse(8) - r * (inverse(9) - r * inverse(10)));
  const double series =
      inverse(3) - r * (inverse(4) - r * (inverse(5) - r * (inverse(6) - r * late)));
  const double low = (x.low - r * x.low) - square.low / 2 + square.high * r * series;
  const DoubleDouble first = fast_sum(r, -square.high / 2);
  return fast_sum(first.high, first.low + low);
}

/// Returns the logarithm of a finite positive number, accurate to about 67 bits.
DoubleDouble log_of(double x) {
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    exponent = -54;
  }
  // Write x = 2^exponent m, with m between the square roots of 1/2 and 2.
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52U) - 1023;
  auto m = std::bit_cast<double>((bits & 0xfffffffffffffU) | 0x3ff0000000000000U);
  if (m > std::numbers::sqrt2) {
    m /= 2;
    ++exponent;
  }
  const auto& [factor, log] = inverses[static_cast<int>(nearest_integer(m * pieces)) - first_piece];
  const DoubleDouble product = exact_product(m, factor);
  const DoubleDouble rest = log_near_1(fast_sum(product.high - 1, product.low));
  return exponent == 0 && factor == 1 ? rest : log_of_2 * exponent + log + rest;
}

bool has_logarithm(double x) { return x > 0 && x < infinity; }

double logarithm_beyond(double x) {
  if (x == 0) return -infinity;
  return x == infinity ? infinity : not_a_number;
}

}  // namespace

double exp(double x) { return exp_of({x, 0}); }

double exp2(double x) {
  if (std::isnan(x)) return not_a_number;
  if (x >= 1024) return infinity;
  if (x < -1080) return 0;
  const double n = nearest_integer(x * steps_per_octave);
  return scaled_exp(static_cast<int>(n), (x - n / steps_per_octave) * log_of_2.high);
}

double log(double x) { return has_logarithm(x) ? log_of(x).value() : logarithm_beyond(x); }

double log2(double x) {
  constexpr DoubleDouble inverse{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
  return has_logarithm(x) ? (log_of(x) * inverse).value() : logarithm_beyond(x);
}

double log10(double x) {
  constexpr DoubleDouble inverse{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
  return has_logarithm(x) ? (log_of(x) * inverse).value() : logarithm_beyond(x);
}

double pow(double base, double exponent) {
  if (exponent == 0 || base == 1) return 1;
  if (!(base >= 0) || std::isnan(exponent)) return not_a_number;
  if (base == 0 || base == infinity) return (base == 0) == (exponent > 0) ? 0 : infinity;
  const DoubleDouble logarithm = log_of(base);
  const double rough = exponent * logarithm.high;
  if (std::abs(rough) < 0x1p-60) return 1;
  if (!(std::abs(rough) < 800)) return exp_of({rough, 0});
  return exp_of(logarithm * exponent);
}

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  return std::copysign(exp_of(log_of(std::abs(x)) / 3), x);
}

}  // namespace transformesh::elementary
