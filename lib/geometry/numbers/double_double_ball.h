/// A real number with an error bound and twice the precision of a double. Predicates use it if
/// doubles do not decide a sign, at a tenth of the cost of exact arithmetic. Requires rounding to
/// nearest. Numbers above 2^480 are treated as unknown; products below 2^-900 are not distinguished
/// from 0. Reference: van der Hoeven, "Ball arithmetic", 2009.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "support/elementary/double_double.h"

namespace transformesh {

class DoubleDoubleBall {
 public:
  DoubleDoubleBall() = default;  ///< the number 0
  explicit DoubleDoubleBall(double number) : value_{number, 0} {}

  /// Returns a ball (number with an error bound) that contains all real numbers.
  static DoubleDoubleBall unknown() {
    DoubleDoubleBall ball;
    ball.error_ = std::numeric_limits<double>::infinity();
    return ball;
  }

  /// Returns +1 or -1 if all numbers within the error bound have that sign, otherwise 0.
  int sign() const {
    const double bound = error_ * slack;
    return value_.high > bound ? 1 : value_.high < -bound ? -1 : 0;
  }

  /// Returns the number rounded towards 0 to a double. Returns nothing if the error bound does not
  /// determine it.
  std::optional<double> truncated() const {
    const double low = std::abs(value_.low);
    if (!(low > error_ * slack) && !(low == 0 && error_ == 0)) return std::nullopt;
    const bool is_above = value_.low != 0 && (value_.low > 0) != (value_.high > 0);
    return is_above ? std::nextafter(value_.high, 0.0) : value_.high;
  }

  /// True if the number is exactly 0, without error.
  bool is_zero() const { return value_.high == 0 && error_ == 0; }

  friend DoubleDoubleBall operator-(const DoubleDoubleBall& a) { return {-a.value_, a.error_}; }
  friend DoubleDoubleBall operator+(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
    const double size = std::abs(a.value_.high) + std::abs(b.value_.high);
    return {a.value_ + b.value_, a.error_ + b.error_ + epsilon * size};
  }
  friend DoubleDoubleBall operator-(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
    const bool is_same = a.value_.high == b.value_.high && a.value_.low == b.value_.low;
    return is_same && a.error_ == 0 && b.error_ == 0 ? DoubleDoubleBall() : a + -b;
  }
  friend DoubleDoubleBall operator*(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double size_a = std::abs(a.value_.high), size_b = std::abs(b.value_.high);
    if (!(size_a < largest && size_b < largest)) return unknown();
    const double error = size_a * b.error_ + (size_b + b.error_) * a.error_;
    return {a.value_ * b.value_, error + epsilon * size_a * size_b + underflow};
  }
  /// The sign of the divisor must be certain; it must not be zero within its error bound.
  friend DoubleDoubleBall operator/(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
    const double size_b = std::abs(b.value_.high);
    if (!(std::abs(a.value_.high) < largest && size_b < largest && size_b > 1 / largest))
      return unknown();
    const elementary::DoubleDouble quotient = a.value_ / b.value_;
    const double size = std::abs(quotient.high);
    if (!(size < largest)) return unknown();
    const double error = (a.error_ + size * b.error_) / (size_b - b.error_) * slack;
    return {quotient, error + epsilon * size + underflow};
  }

 private:
  /// Relative error bound of sums, products and quotients of two double-doubles.
  static constexpr double epsilon = 0x1p-98;
  static constexpr double slack = 1 + 0x1p-40;  // factor that covers the rounding of errors
  static constexpr double largest = 0x1p480;
  /// Value that exceeds the error of a product that underflows.
  static constexpr double underflow = 0x1p-900;

  DoubleDoubleBall(const elementary::DoubleDouble& value, double error)
      : value_(value), error_(error * slack) {
    if (!std::isfinite(value_.high) || !std::isfinite(error_)) *this = unknown();
  }

  elementary::DoubleDouble value_;
  double error_ = 0;
};

}  // namespace transformesh
