/// Exact sums of doubles, of bounded length: what decides signs of determinants of doubles where
/// balls leave them open, most often because they are 0. Rounding is to nearest. Nothing may over-
/// or underflow, which is the caller's care.
/// Reference: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates", DCG 1997.
#pragma once

#include <array>
#include <cmath>

#include "tm/support/elementary/double_double.h"

namespace transformesh {

/// The sum of its terms, which do not overlap and ascend in magnitude; none is 0.
template <int Most>
class Expansion {
 public:
  Expansion() {}  // NOLINT(modernize-use-equals-default): terms are left as they are
  static Expansion product(double a, double b) requires(Most == 2) {
    const elementary::DoubleDouble exact = elementary::exact_product(a, b);
    Expansion result;
    result.append(exact.low);
    result.append(exact.high);
    return result;
  }

  int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }
  int size() const { return size_; }
  double operator[](int i) const { return terms_[i]; }
  /// Behind what is there; 0 is left out.
  void append(double term) {
    if (term != 0) terms_[size_++] = term;
  }
  Expansion operator-() const {
    Expansion result;
    for (int i = 0; i < size_; ++i) result.append(-terms_[i]);
    return result;
  }

 private:
  std::array<double, Most> terms_;  // as many as there are
  int size_ = 0;
};

/// The terms of both are merged by magnitude and summed from the smallest on.
template <int A, int B>
Expansion<A + B> operator+(const Expansion<A>& a, const Expansion<B>& b) {
  Expansion<A + B> result;
  double carry = 0;
  for (int i = 0, k = 0; i < a.size() || k < b.size();) {
    const bool from_a = k == b.size() || (i < a.size() && std::abs(a[i]) < std::abs(b[k]));
    const elementary::DoubleDouble sum = elementary::exact_sum(carry, from_a ? a[i++] : b[k++]);
    result.append(sum.low);
    carry = sum.high;
  }
  result.append(carry);
  return result;
}

template <int A>
Expansion<2 * A> operator*(const Expansion<A>& a, double factor) {
  Expansion<2 * A> result;
  double carry = 0;
  for (int i = 0; i < a.size(); ++i) {
    const elementary::DoubleDouble product = elementary::exact_product(a[i], factor);
    const elementary::DoubleDouble low = elementary::exact_sum(carry, product.low);
    result.append(low.low);
    const elementary::DoubleDouble high = elementary::exact_sum(product.high, low.high);
    result.append(high.low);
    carry = high.high;
  }
  result.append(carry);
  return result;
}

}  // namespace transformesh
