#include "geometry/numbers/multiprecision_ball.h"

namespace transformesh {
namespace {

__extension__ using Twice = unsigned __int128;

}  // namespace

// Shifts the digits down, and increases the exponent accordingly. Digits below the last word are
// dropped. `count` must be at most `bits`.
void MultiprecisionBall::shift_right(std::int64_t count) {
  const auto words = static_cast<std::size_t>(count / 64);
  const auto rest = static_cast<unsigned>(count % 64);
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint64_t low = i + words < length ? digits_[i + words] : 0;
    const std::uint64_t high = i + words + 1 < length ? digits_[i + words + 1] : 0;
    digits_[i] = rest == 0 ? low : (low >> rest) | (high << (64 - rest));
  }
  exponent_ += count;
}

void MultiprecisionBall::normalize() {
  std::size_t words = 0;
  while (words < length && digits_[length - 1 - words] == 0) ++words;
  if (words == length) {
    sign_ = 0;
    return;
  }
  const auto rest = static_cast<unsigned>(std::countl_zero(digits_[length - 1 - words]));
  for (std::size_t i = length; i-- > 0;) {
    const std::uint64_t high = i >= words ? digits_[i - words] : 0;
    const std::uint64_t low = i >= words + 1 ? digits_[i - words - 1] : 0;
    digits_[i] = rest == 0 ? high : (high << rest) | (low >> (64 - rest));
  }
  exponent_ -= static_cast<std::int64_t>(64 * words + rest);
}

// Adds or subtracts the digits of `other`. Both numbers must have the same exponent. If `is_sum` is
// false, `other` is subtracted and must not be larger.
void MultiprecisionBall::add_digits(const MultiprecisionBall& other, bool is_sum) {
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const Twice term = Twice(other.digits_[i]) + carry;
    const Twice sum = is_sum ? digits_[i] + term : digits_[i] - term;
    digits_[i] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64U) & (is_sum ? 3U : 1U);
  }
  if (is_sum && carry != 0) {
    shift_right(1);
    digits_.back() |= std::uint64_t{1} << 63U;
  }
}

MultiprecisionBall operator+(const MultiprecisionBall& a, const MultiprecisionBall& b) {
  const auto order = [](const MultiprecisionBall& x) {
    return x.sign_ == 0 ? INT64_MIN / 2 : x.exponent_;
  };
  const bool is_swapped =
      order(a) < order(b) ||
      (order(a) == order(b) && std::lexicographical_compare(a.digits_.rbegin(), a.digits_.rend(),
                                                            b.digits_.rbegin(), b.digits_.rend()));
  MultiprecisionBall sum = is_swapped ? b : a, less = is_swapped ? a : b;
  sum.error_ = a.error_ + b.error_;
  if (less.sign_ == 0) return sum;
  const std::int64_t shift = sum.exponent_ - less.exponent_;
  if (shift >= MultiprecisionBall::bits) {
    sum.error_ = sum.error_ + less.size();
    return sum;
  }
  // Add the error of shifts to the bound: each shift drops less than one unit in the last place.
  if (shift > 0 || sum.sign_ == less.sign_)
    sum.error_ = sum.error_ + WideBound::power(sum.exponent_ + 2 - MultiprecisionBall::bits);
  less.shift_right(shift);
  sum.add_digits(less, sum.sign_ == less.sign_);
  sum.normalize();
  return sum;
}

// Multiplies the digits word by word. Zero words are skipped, because numbers made of few doubles
// have few nonzero words. Words below the last word of the product are computed only if they could
// carry into it. The remainder is less than one unit in the last place.
MultiprecisionBall operator*(const MultiprecisionBall& a, const MultiprecisionBall& b) {
  constexpr std::size_t length = MultiprecisionBall::length;
  constexpr std::size_t least_place = length - 2;  // lower words are needed only for their carry
  MultiprecisionBall product;
  product.error_ = a.size() * b.error_ + a.error_ * b.size() + a.error_ * b.error_;
  product.sign_ = a.sign_ * b.sign_;
  if (product.sign_ == 0) return product;

  std::size_t last_digit = 0;
  while (b.digits_[last_digit] == 0) ++last_digit;
  std::array<std::uint64_t, 2 * length> digits{};
  for (std::size_t i = 0; i < length; ++i) {
    if (a.digits_[i] == 0) continue;
    std::uint64_t carry = 0;
    for (std::size_t j = std::max(last_digit, least_place - std::min(i, least_place)); j < length;
         ++j) {
      const Twice sum = Twice(a.digits_[i]) * b.digits_[j] + digits[i + j] + carry;
      digits[i + j] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64U);
    }
    digits[i + length] = carry;
  }
  product.exponent_ = a.exponent_ + b.exponent_;
  std::copy(digits.begin() + length, digits.end(), product.digits_.begin());
  product.error_ =
      product.error_ + WideBound::power(product.exponent_ + 1 - MultiprecisionBall::bits);
  product.normalize();
  return product;
}

}  // namespace transformesh
