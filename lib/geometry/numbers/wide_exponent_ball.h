/// A real number with an error bound in doubles, and an exponent that neither overflows nor
/// underflows. Predicates use it if products leave the range of doubles, at a tenth of the cost of
/// exact arithmetic. Valid in any rounding mode. Reference: van der Hoeven, "Ball arithmetic",
/// 2009.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/numbers/binary_exponent.h"

namespace transformesh {

class WideExponentBall {
 public:
  WideExponentBall() = default;  ///< the number 0
  explicit WideExponentBall(double number) : WideExponentBall(number, 0, 0) {}
  WideExponentBall(double center, double radius) : WideExponentBall(center, radius, 0) {}

  /// Returns a ball (number with an error bound) that contains all real numbers.
  static WideExponentBall unknown() { return {0, std::numeric_limits<double>::infinity()}; }

  /// Returns +1 or -1 if all numbers within the error bound have that sign, otherwise 0.
  int sign() const { return value_ > error_ ? 1 : value_ < -error_ ? -1 : 0; }
  /// Return the lower and upper bound of the number. Infinite if they exceed the range of doubles.
  double low() const { return to_double(value_ - error_, -1); }
  double high() const { return to_double(value_ + error_, 1); }

  friend WideExponentBall operator-(const WideExponentBall& a) {
    return {-a.value_, a.error_, a.exponent_};
  }
  friend WideExponentBall operator+(const WideExponentBall& a, const WideExponentBall& b) {
    if (a.exponent_ < b.exponent_) return b + a;
    if (b.value_ == 0 && b.error_ == 0) return a;
    if (a.value_ == 0 && a.error_ == 0) return b;
    const int shift = b.exponent_ - a.exponent_;
    const double scale = power_of_two(shift);
    const double value = a.value_ + b.value_ * scale;
    const double lost = shift < -900 ? underflow : 0;
    return {value, a.error_ + b.error_ * scale + epsilon * std::abs(value) + lost, a.exponent_};
  }
  friend WideExponentBall operator-(const WideExponentBall& a, const WideExponentBall& b) {
    return a + -b;
  }
  friend WideExponentBall operator*(const WideExponentBall& a, const WideExponentBall& b) {
    const double value = a.value_ * b.value_;
    return {value,
            std::abs(a.value_) * b.error_ + a.error_ * (std::abs(b.value_) + b.error_) +
                epsilon * std::abs(value),
            a.exponent_ + b.exponent_};
  }
  /// The sign of the divisor must be certain; it must not be zero within its error bound.
  friend WideExponentBall operator/(const WideExponentBall& a, const WideExponentBall& b) {
    const double value = a.value_ / b.value_;
    const double error =
        (a.error_ + std::abs(value) * b.error_) / (std::abs(b.value_) - b.error_) * slack;
    return {value, error + epsilon * std::abs(value), a.exponent_ - b.exponent_};
  }

 private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double slack = 1 + 32 * epsilon;  // factor that covers the rounding of errors
  /// Value that exceeds the error of a product that underflows.
  static constexpr double underflow = 0x1p-900;

  // Scales value and error such that the larger of them is in [1, 2). If one of them is not finite,
  // the number becomes unknown.
  WideExponentBall(double value, double error, int exponent) {
    const double size = std::max(std::abs(value), error);
    if (size == 0 && error == 0) return;
    if (!std::isfinite(value) || !std::isfinite(error)) {
      error_ = std::numeric_limits<double>::infinity();
      return;
    }
    const int shift = binary_exponent(size);
    const double scale = power_of_two(-shift);
    value_ = value * scale;
    error_ = error == 0 ? 0 : error * scale * slack + underflow;
    exponent_ = exponent + shift;
  }

  double to_double(double end, int direction) const {
    const double number = std::ldexp(end, std::clamp(exponent_, -3000, 3000));
    return std::nextafter(number, direction * std::numeric_limits<double>::infinity());
  }

  double value_ = 0, error_ = 0;
  int exponent_ = 0;
};

/// True if sums of products of this size may have overflowed or underflowed in doubles. Then a
/// WideExponentBall is more precise than doubles with an error bound. A size of 0 means that all
/// terms are zero.
inline bool leaves_double_range(double size) {
  return size != 0 && !(size > 1e-260 && size < 1e300);
}

}  // namespace transformesh
