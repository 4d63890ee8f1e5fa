/// An integer of any size times a power of two. Represents every finite double, and all sums and
/// products of doubles, exactly. Needs only Boost.Multiprecision, so that builds without GMP have
/// exact numbers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace transformesh {

class DyadicNumber {
 public:
  DyadicNumber() = default;  ///< the number 0
  /// The number must be finite.
  explicit DyadicNumber(double number) {
    if (number == 0) return;
    int exponent = 0;
    const double fraction = std::frexp(number, &exponent);
    auto digits = static_cast<std::int64_t>(std::ldexp(fraction, digits_of_double));
    exponent_ = exponent - digits_of_double;
    for (; digits % 2 == 0; digits /= 2) ++exponent_;
    digits_ = digits;
  }

  int sign() const { return digits_.sign(); }
  friend int sign(const DyadicNumber& number) { return number.sign(); }

  friend DyadicNumber operator-(const DyadicNumber& a) { return {-a.digits_, a.exponent_}; }
  friend DyadicNumber operator+(const DyadicNumber& a, const DyadicNumber& b) {
    if (a.exponent_ < b.exponent_) return b + a;
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    return {(a.digits_ << (a.exponent_ - b.exponent_)) + b.digits_, b.exponent_};
  }
  friend DyadicNumber operator-(const DyadicNumber& a, const DyadicNumber& b) { return a + -b; }
  friend DyadicNumber operator*(const DyadicNumber& a, const DyadicNumber& b) {
    return {a.digits_ * b.digits_, a.exponent_ + b.exponent_};
  }

  /// Returns the quotient, rounded towards 0.
  friend double truncated_quotient(const DyadicNumber& numerator,
                                   const DyadicNumber& positive_denominator) {
    if (numerator.sign() == 0) return 0;
    Integer above = numerator.sign() < 0 ? Integer(-numerator.digits_) : numerator.digits_;
    Integer below = positive_denominator.digits_;
    const std::int64_t bits =
        static_cast<std::int64_t>(msb(above)) - static_cast<std::int64_t>(msb(below));
    // The quotient of the shifted digits has 64 or 65 bits. The leading 53 of them become the
    // double.
    const std::int64_t shift = 64 - bits;
    if (shift >= 0)
      above <<= shift;
    else
      below <<= -shift;
    Integer digits = above / below;
    std::int64_t exponent = numerator.exponent_ - positive_denominator.exponent_ - shift;
    // Denormal numbers keep fewer bits than normal ones. Numbers below the smallest double keep
    // none.
    const auto size = static_cast<std::int64_t>(msb(digits)) + 1;
    const std::int64_t lost = std::max(size - digits_of_double, least_exponent - exponent);
    digits >>= lost;
    exponent += lost;
    const double magnitude = std::ldexp(digits.convert_to<double>(),
                                        static_cast<int>(std::min<std::int64_t>(exponent, 5000)));
    return numerator.sign() < 0 ? -magnitude : magnitude;
  }

 private:
  using Integer = boost::multiprecision::cpp_int;

  static constexpr int digits_of_double = std::numeric_limits<double>::digits;
  static constexpr std::int64_t least_exponent =
      std::numeric_limits<double>::min_exponent - digits_of_double;  // exponent of the least double

  DyadicNumber(Integer digits, std::int64_t exponent)
      : digits_(std::move(digits)), exponent_(exponent) {}

  Integer digits_;
  std::int64_t exponent_ = 0;
};

}  // namespace transformesh
