#include "geometry/numbers/monomial_sum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/numbers/binary_exponent.h"
#include "geometry/numbers/fixed_integer.h"

namespace transformesh {
namespace {

constexpr std::uint64_t low_bits(unsigned count) { return (std::uint64_t{1} << count) - 1; }

}  // namespace

BinaryDigits::BinaryDigits(double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const auto biased = static_cast<int>(bits >> 52U & 0x7ffU);
  digits = (bits & low_bits(52)) | std::uint64_t{biased == 0 ? 0U : 1U} << 52U;
  exponent = std::max(biased, 1) - 1075;
  is_negative = bits >> 63U != 0;
}

/// A partial sum, stored as an integer of eight words times 2^bottom. The exponents of its terms
/// are at most `depth` above `bottom`, so that no sum of terms overflows.
class MonomialSum::Window {
 public:
  /// Largest difference between the exponent of a term and `bottom`. These 320 bits and the three
  /// words of a term fill `length` words.
  static constexpr int depth = 320;

  explicit Window(int bottom) : bottom_(bottom) {}

  int sign() const { return sum_.sign(); }

  // Adds a term. A negative term is added in two's complement: the complement of its digits, plus
  // one.
  void add(const Term& term) {
    const auto place = static_cast<unsigned>(term.exponent - bottom_);
    const unsigned shift = place % 64;
    std::uint64_t below = 0, carry = term.is_negative ? 1 : 0;
    const std::uint64_t flip = term.is_negative ? ~std::uint64_t{0} : 0;
    for (std::size_t word = place / 64, i = 0; word < length; ++word, ++i) {
      const std::uint64_t here = i < 3 ? term.digits[i] : 0;
      const std::uint64_t shifted = shift == 0 ? here : here << shift | below >> (64 - shift);
      below = here;
      const TwoWords sum = TwoWords(sum_.words[word]) + (shifted ^ flip) + carry;
      sum_.words[word] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64U);
    }
  }

  /// True if the sum is so small that terms below the window could change its sign.
  bool is_small() const {
    const FixedInteger<length> size = magnitude();
    return std::all_of(size.words.begin() + 3, size.words.end(),
                       [](auto word) { return word == 0; }) &&
           size.words[2] <= low_bits(40);
  }

  /// Returns the sum as a term for the next window. Pre: is_small().
  Term term() const {
    const FixedInteger<length> size = magnitude();
    return {{size.words[0], size.words[1], size.words[2]}, bottom_, sum_.is_negative()};
  }

 private:
  static constexpr std::size_t length = 8;  ///< number of 64-bit words

  FixedInteger<length> magnitude() const {
    return sum_.is_negative() ? FixedInteger<length>() - sum_ : sum_;
  }

  FixedInteger<length> sum_;
  int bottom_;
};

void MonomialSum::add(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c) {
  add_product(a, b, c, a.is_negative != (b.is_negative != c.is_negative));
}

void MonomialSum::subtract(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c) {
  add_product(a, b, c, a.is_negative == (b.is_negative != c.is_negative));
}

void MonomialSum::add_product(const BinaryDigits& a, const BinaryDigits& b, const BinaryDigits& c,
                              bool is_negative) {
  if (a.digits == 0 || b.digits == 0 || c.digits == 0) return;
  const TwoWords ab = TwoWords(a.digits) * b.digits;
  const TwoWords low = TwoWords(static_cast<std::uint64_t>(ab)) * c.digits;
  const TwoWords high = TwoWords(static_cast<std::uint64_t>(ab >> 64U)) * c.digits + (low >> 64U);
  terms_[count_] = {{static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high),
                     static_cast<std::uint64_t>(high >> 64U)},
                    a.exponent + b.exponent + c.exponent,
                    is_negative};
  const double size =
      static_cast<double>(a.digits) * static_cast<double>(b.digits) * static_cast<double>(c.digits);
  sizes_[count_++] = is_negative ? -size : size;
}

int MonomialSum::sign() const {
  const int sign = quick_sign();
  return sign != 0 ? sign : exact_sign();
}

// Returns the sign if doubles decide it, otherwise 0. Terms are relative to the largest one. Each
// product is rounded twice, and each addition once.
int MonomialSum::quick_sign() const {
  // Relative error bound: two roundings for each of at most `most` terms.
  constexpr double error = 2 * most * std::numeric_limits<double>::epsilon();
  constexpr double underflow = 0x1p-800;  // exceeds the error of terms that underflow
  int top = std::numeric_limits<int>::min();
  for (std::size_t i = 0; i < count_; ++i) top = std::max(top, terms_[i].exponent);
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double term = sizes_[i] * power_of_two(terms_[i].exponent - top);
    sum += term;
    size += std::abs(term);
  }
  const double bound = error * size + underflow;
  return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

// Returns the exact sign. Adds terms in order of descending exponents, in windows of terms whose
// exponents differ by at most `depth`. If the sum of a window is small, it is the first term of the
// next window.
int MonomialSum::exact_sign() const {
  std::array<std::size_t, most> order;
  for (std::size_t i = 0; i < count_; ++i) {
    std::size_t place = i;
    for (; place > 0 && terms_[order[place - 1]].exponent < terms_[i].exponent; --place)
      order[place] = order[place - 1];
    order[place] = i;
  }
  Term rest{};
  bool is_rest = false;
  for (std::size_t next = 0; next < count_;) {
    const int bottom = (is_rest ? rest.exponent : terms_[order[next]].exponent) - Window::depth;
    Window window(bottom);
    if (is_rest) window.add(rest);
    for (; next < count_ && terms_[order[next]].exponent >= bottom; ++next)
      window.add(terms_[order[next]]);
    is_rest = window.sign() != 0;
    if (next == count_ || !window.is_small()) return window.sign();
    rest = window.term();
  }
  return 0;
}

}  // namespace transformesh
