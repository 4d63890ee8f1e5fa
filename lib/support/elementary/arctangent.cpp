#include "support/elementary/arctangent.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/elementary/double_double.h"

namespace transformesh::elementary {
namespace {

constexpr int steps_to_1 = 64;       ///< number of table intervals from 0 to 1
constexpr int first_table_step = 8;  ///< below this table entry, the power series is used

constexpr DoubleDouble arctangent_series(const DoubleDouble& x) {
  DoubleDouble sum;
  for (int n = 25; n > 0; n -= 2) sum = one / n + -(sum * (x * x));
  return x * sum;
}

/// Entry j is atan(j/64). It is the previous entry plus atan(1 / (64 + j (j - 1) / 64)).
constexpr auto angle_table = [] {
  std::array<DoubleDouble, steps_to_1 + 1> angles;
  for (int j = 1; j <= steps_to_1; ++j)
    angles[j] = angles[j - 1] + arctangent_series(one / (steps_to_1 + j * (j - 1.0) / steps_to_1));
  return angles;
}();

// Returns the arctangent of low / high by its power series. The quotient must be at most 1/8.
DoubleDouble angle_by_series(double low, double high) {
  const double quotient = low / high;
  const DoubleDouble product = exact_product(quotient, high);
  const double rest = ((low - product.high) - product.low) / high;
  const double z = quotient * quotient;
  const double late = inverse(11) - z * (inverse(13) - z * (inverse(15) - z * inverse(17)));
  const double series =
      inverse(-3) + z * (inverse(5) - z * (inverse(7) - z * (inverse(9) - z * late)));
  return fast_sum(quotient, rest + quotient * z * series);
}

// Returns the arctangent of low / high: the nearest angle of the table plus a difference. The
// numerator of the difference is computed without rounding its terms. For this, `high` is split:
// `first` consists of its leading 45 bits, and tangents in the table have only 7 bits.
DoubleDouble angle_by_table(double low, double high) {
  const double step = nearest_integer(low / high * steps_to_1);
  const double tangent = step / steps_to_1;
  const auto first = std::bit_cast<double>(std::bit_cast<std::uint64_t>(high) & ~0xffULL);
  const double numerator = (low - tangent * first) - tangent * (high - first);
  const double x = numerator / (high + tangent * low);
  const double z = x * x;
  const double series = inverse(-3) + z * (inverse(5) - z * (inverse(7) - z * inverse(9)));
  const DoubleDouble& nearest = angle_table[static_cast<std::size_t>(step)];
  return fast_sum(nearest.high, x + (nearest.low + x * z * series));
}

/// Returns the angle whose tangent is low / high, for angles up to pi/4.
DoubleDouble angle_of(double low, double high) {
  return low * steps_to_1 < high * first_table_step ? angle_by_series(low, high)
                                                    : angle_by_table(low, high);
}

/// Returns the rounded sum a + b. The magnitude of a must not be smaller than that of b.
double rounded_sum(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = fast_sum(a.high, b.high);
  return high.high + (high.low + (a.low + b.low));
}

/// Returns the angle of a point with positive coordinates, or of its mirror image at the y axis.
double angle_in_half_plane(double y, double x, bool is_left) {
  if (y > x) {
    const DoubleDouble from_axis = angle_of(x, y);
    return rounded_sum(half_pi, is_left ? from_axis : -from_axis);
  }
  const DoubleDouble angle = angle_of(y, x);
  return is_left ? rounded_sum(pi, -angle) : angle.value();
}

bool is_moderate(double x) { return x > 0x1p-450 && x < 0x1p450; }

/// Handles coordinates that are 0, very large, very small, or not finite.
double extreme_angle(double y, double x, bool is_left) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  if (std::max(x, y) == infinity) {
    x = x == infinity ? 1 : 0;
    y = y == infinity ? 1 : 0;
  }
  const double larger = std::max(x, y);
  if (larger == 0) return is_left ? pi.high : 0;
  // Scales the larger coordinate to about 1. If the smaller coordinate is then below `negligible`,
  // it does not affect the rounded angle, or the angle equals its tangent.
  constexpr double negligible = 0x1p-60;
  const int exponent = std::ilogb(larger);
  const double scaled_x = std::ldexp(x, -exponent);
  const double scaled_y = std::ldexp(y, -exponent);
  if (scaled_y < negligible) return is_left ? pi.high : y / x;
  if (scaled_x < negligible) return half_pi.high;
  return angle_in_half_plane(scaled_y, scaled_x, is_left);
}

}  // namespace

double atan2(double y, double x) {
  const double height = std::abs(y);
  const double width = std::abs(x);
  const bool is_left = std::signbit(x);
  const bool is_usual = is_moderate(height) && is_moderate(width);
  const double angle = is_usual ? angle_in_half_plane(height, width, is_left)
                                : extreme_angle(height, width, is_left);
  return std::copysign(angle, y);
}

double atan(double x) { return atan2(x, 1); }

}  // namespace transformesh::elementary
