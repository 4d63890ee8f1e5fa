/// A real number known up to an error, in doubles: the first stage of predicates. Rounding is to
/// nearest. Unlike intervals it needs no change of the rounding mode, and unlike them it decides
/// nothing near underflow. Reference: van der Hoeven, "Ball arithmetic", 2009.
#pragma once

#include <cmath>
#include <limits>

namespace transformesh {

struct BoundedNumber {
  double value = 0;  ///< computed
  double error = 0;  ///< the true number is within, but for rounding of the error

  /// +1 or -1 where that is certain, else 0.
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
  static constexpr double underflow = 1e-280;
};

}  // namespace transformesh
