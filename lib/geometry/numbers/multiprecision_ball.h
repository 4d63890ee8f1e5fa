/// A real number with an error bound, 512 bits, and an exponent that neither overflows nor
/// underflows. Predicates use it if coordinates of a mesh differ by hundreds of orders of
/// magnitude, at a fraction of the cost of exact arithmetic. Sums and products use integers and are
/// valid in any rounding mode. Reference: van der Hoeven, "Ball arithmetic", 2009.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/numbers/binary_exponent.h"

namespace transformesh {

/// An upper bound of any magnitude: number * 2^exponent.
class WideBound {
 public:
  WideBound() = default;  ///< the number 0
  WideBound(double number, std::int64_t exponent) {
    if (number == 0) return;
    const int shift = binary_exponent(number);
    number_ = number * power_of_two(-shift) * slack;
    exponent_ = exponent + shift;
  }
  static WideBound power(std::int64_t exponent) { return {1, exponent}; }
  static WideBound infinite() {
    WideBound bound;
    bound.number_ = std::numeric_limits<double>::infinity();
    return bound;
  }

  bool is_below_power(std::int64_t exponent) const {
    return number_ == 0 || (is_finite() && exponent_ + 1 < exponent);
  }

  friend WideBound operator+(const WideBound& a, const WideBound& b) {
    if (a.number_ == 0 || !b.is_finite()) return b;
    if (b.number_ == 0 || !a.is_finite()) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    const auto shift = std::max<std::int64_t>(b.exponent_ - a.exponent_, -100);
    return {a.number_ + b.number_ * power_of_two(static_cast<int>(shift)), a.exponent_};
  }
  friend WideBound operator*(const WideBound& a, const WideBound& b) {
    if (a.number_ == 0 || b.number_ == 0) return {};
    if (!a.is_finite() || !b.is_finite()) return infinite();
    return {a.number_ * b.number_, a.exponent_ + b.exponent_};
  }

 private:
  // Factor of an upper bound. It covers rounding errors and the error of limiting shifts to 100
  // bits.
  static constexpr double slack = 1 + 0x1p-50;

  bool is_finite() const { return number_ < 4; }

  double number_ = 0;  ///< number of the bound: 0, infinity, or in [1, 2) times `slack`
  std::int64_t exponent_ = 0;
};

class MultiprecisionBall {
 public:
  MultiprecisionBall() = default;  ///< the number 0
  explicit MultiprecisionBall(double number) {
    if (number == 0) return;
    if (!std::isfinite(number)) {
      error_ = WideBound::infinite();
      return;
    }
    int exponent = 0;
    const double fraction = std::frexp(std::abs(number), &exponent);
    digits_.back() = static_cast<std::uint64_t>(std::ldexp(fraction, 64));
    exponent_ = exponent;
    sign_ = number < 0 ? -1 : 1;
  }

  /// Returns a ball (number with an error bound) that contains all real numbers.
  static MultiprecisionBall unknown() {
    MultiprecisionBall ball;
    ball.error_ = WideBound::infinite();
    return ball;
  }

  /// Returns +1 or -1 if all numbers within the error bound have that sign, otherwise 0.
  int sign() const { return error_.is_below_power(exponent_ - 1) ? sign_ : 0; }

  friend MultiprecisionBall operator-(MultiprecisionBall a) {
    a.sign_ = -a.sign_;
    return a;
  }
  friend MultiprecisionBall operator+(const MultiprecisionBall& a, const MultiprecisionBall& b);
  friend MultiprecisionBall operator-(const MultiprecisionBall& a, const MultiprecisionBall& b) {
    return a + -b;
  }
  friend MultiprecisionBall operator*(const MultiprecisionBall& a, const MultiprecisionBall& b);

 private:
  static constexpr std::size_t length = 8;           ///< number of 64-bit words of the value
  static constexpr std::int64_t bits = 64 * length;  ///< number of bits of the value
  using Digits = std::array<std::uint64_t, length>;  ///< 64-bit words, the least significant first

  WideBound size() const { return sign_ == 0 ? WideBound() : WideBound::power(exponent_); }
  void add_digits(const MultiprecisionBall& other, bool is_sum);
  void shift_right(std::int64_t count);
  void normalize();

  /// Digits of the value, which is sign * 0.digits * 2^exponent. The leading bit is 1 unless the
  /// sign is 0.
  Digits digits_{};
  int sign_ = 0;
  std::int64_t exponent_ = 0;
  WideBound error_;
};

}  // namespace transformesh
