/// A real number with an error bound, in doubles; predicates try it first. Unlike interval
/// arithmetic, it works with rounding to nearest and needs no change of the rounding mode. It does
/// not decide a sign if products come close to underflow. Reference: van der Hoeven, "Ball
/// arithmetic", 2009.
#pragma once

#include <cmath>
#include <limits>

namespace transformesh {

struct BoundedNumber {
  double value = 0;  ///< computed value
  /// Bound of the distance from the true number, up to rounding of the bound itself.
  double error = 0;

  /// Returns +1 or -1 if the sign is certain, otherwise 0.
  int sign() const {
    const double bound = error * (1 + 64 * epsilon) + underflow;
    return value > bound ? 1 : value < -bound ? -1 : 0;
  }

  friend BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
    const double sum = a.value + b.value;
    return {sum, a.error + b.error + epsilon * std::abs(sum)};
  }
  friend BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) {
    const double difference = a.value - b.value;
    return {difference, a.error + b.error + epsilon * std::abs(difference)};
  }
  friend BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
    const double product = a.value * b.value;
    return {product, std::abs(a.value) * b.error + a.error * (std::abs(b.value) + b.error) +
                         epsilon * std::abs(product)};
  }

 private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  /// Value that exceeds the error of a product that underflows.
  static constexpr double underflow = 1e-280;
};

}  // namespace transformesh
