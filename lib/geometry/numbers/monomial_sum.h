/// The sign of a sum of products of a few doubles of any magnitudes: exact, zeros included, and
/// with no number that grows. What decides determinants of coordinates that differ by hundreds of
/// orders of magnitude. The products are exact, of three words each, and are added within a window
/// of eight words below the largest, then within further windows while what is left could turn the
/// sign. Reference: Kulisch and Miranker, "Computer Arithmetic in Theory and Practice", 1981 (sums
/// in an accumulator of fixed point).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace transformesh {

/// A double as an integer of 53 bits, times two to the exponent.
struct BinaryDigits {
  std::uint64_t digits = 0;
  int exponent = 0;
  bool is_negative = false;

  BinaryDigits() = default;
  explicit BinaryDigits(double number);  ///< of a finite one
};

/// Of at most `most` products of three doubles. Any rounding mode.
class MonomialSum {
 public:
  static constexpr std::size_t most = 24;

  void add(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c);
  void subtract(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c);
  /// -1, 0 or +1.
  int sign() const;

 private:
  /// An integer below 2^190 times two to the exponent.
  struct Term {
    std::array<std::uint64_t, 3> digits;  ///< least significant first
    int exponent;
    bool is_negative;
  };
  class Window;

  void add_product(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c,
                   bool is_negative);
  int quick_sign() const;
  int exact_sign() const;

  std::array<Term, most> terms_;
  std::array<double, most> sizes_;  ///< the digits of each, rounded
  std::size_t count_ = 0;
};

}  // namespace transformesh
