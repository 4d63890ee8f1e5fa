/// Double-double arithmetic: a number is the sum of two doubles, with about 104 bits. Only IEEE
/// operations are used, so results are the same on every machine. Magnitudes must be 0 or in
/// [2^-480, 2^480]. References: Dekker, "A floating-point technique for extending the available
/// precision", Numerische Mathematik 18, 1971; Knuth, "The Art of Computer Programming", vol. 2,
/// 4.2.2.
#pragma once

namespace transformesh::elementary {

/// Invariant: `low` is at most half a unit in the last place of `high`.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr double value() const { return high + low; }
  constexpr DoubleDouble operator-() const { return {-high, -low}; }
};

/// Returns the exact sum of a and b. Requires that a is 0 or not smaller than b in magnitude.
constexpr DoubleDouble fast_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

constexpr DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

constexpr DoubleDouble exact_product(double a, double b) {
  // Splits a and b into halves of 26 bits (Veltkamp).
  constexpr double splitter = 0x1p27 + 1;
  const double a_high = splitter * a - (splitter * a - a);
  const double b_high = splitter * b - (splitter * b - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_sum(a.high, b.high);
  const DoubleDouble low = exact_sum(a.low, b.low);
  const DoubleDouble sum = fast_sum(high.high, high.low + low.high);
  return fast_sum(sum.high, sum.low + low.low);
}

constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.high, b.high);
  return fast_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator*(const DoubleDouble& a, double b) { return a * DoubleDouble{b, 0}; }

constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a + -(b * first);
  const double second = rest.high / b.high;
  const DoubleDouble remainder = rest + -(b * second);
  const DoubleDouble quotient = fast_sum(first, second);
  return fast_sum(quotient.high, quotient.low + remainder.high / b.high);
}

constexpr DoubleDouble operator/(const DoubleDouble& a, double b) { return a / DoubleDouble{b, 0}; }

/// Returns 1/x as a constant. consteval, because under strict rounding semantics compilers leave
/// divisions to run time.
consteval double inverse(double x) { return 1 / x; }

/// Returns the nearest integer. Requires a magnitude below 2^51.
constexpr double nearest_integer(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

constexpr DoubleDouble one{1, 0};
constexpr DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr DoubleDouble log_of_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

}  // namespace transformesh::elementary
