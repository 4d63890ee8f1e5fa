/// The sign of a sum of products of a few doubles of any magnitude. Exact, including zeros, without
/// numbers of growing length. Decides determinants of coordinates that differ by hundreds of orders
/// of magnitude. Each product is exact in three words. Products are added in a window of eight
/// words below the largest one. Further windows follow as long as the remaining terms could change
/// the sign. Reference: Kulisch and Miranker, "Computer Arithmetic in Theory and Practice", 1981
/// (sums in a fixed-point accumulator). Departure: the accumulator moves instead of covering all
/// exponents.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace transformesh {

/// A double as a 53-bit integer times 2^exponent.
struct BinaryDigits {
  std::uint64_t digits = 0;
  int exponent = 0;
  bool is_negative = false;

  BinaryDigits() = default;
  explicit BinaryDigits(double number);  ///< `number` must be finite
};

/// Sum of at most `most` products of three doubles. Valid in any rounding mode.
class MonomialSum {
 public:
  static constexpr std::size_t most = 24;  ///< largest number of terms; no predicate has more

  void add(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c);
  void subtract(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c);
  /// Returns -1, 0 or +1.
  int sign() const;

 private:
  /// A product of three doubles, or a partial sum: an integer below 2^190, times 2^exponent.
  struct Term {
    std::array<std::uint64_t, 3> digits;  ///< least significant word first
    int exponent;
    bool is_negative;
  };
  class Window;

  void add_product(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c,
                   bool is_negative);
  int quick_sign() const;
  int exact_sign() const;

  std::array<Term, most> terms_;
  /// For each term, its digits as a rounded double, with its sign.
  std::array<double, most> sizes_;
  std::size_t count_ = 0;
};

}  // namespace transformesh
