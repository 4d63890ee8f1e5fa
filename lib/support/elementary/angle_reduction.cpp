#include "support/elementary/angle_reduction.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace transformesh::elementary {
namespace {

// Limit between the two reduction methods. For smaller angles, the rounded quotient of angle and
// pi/2 is less than 2^20. Its products with `parts`, except for the last part, are then exact.
constexpr double least_large = 0x1p20;

/// The sum of these parts is pi/2. All parts except the last have 33 bits, so their products with
/// integers up to 2^20 are exact.
constexpr std::array parts = {0x1.921fb54400000p+0, 0x1.0b4611a600000p-34, 0x1.3198a2e000000p-69,
                              0x1.b839a252049c1p-104};

// Reduces moderate angles (Cody & Waite). Two numbers, the first part of pi/2 and the sum of the
// other parts, are enough unless the angle is close to a multiple of pi/2.
ReducedAngle reduced_by_parts(double x) {
  constexpr double all_but_first = 0x1.0b4611a626331p-34;  // pi/2 without its first part
  // If the angle is closer to a multiple of pi/2, the error of `all_but_first` is too large.
  constexpr double near = 0x1p-6;
  const double n = nearest_integer(x * inverse(half_pi.high));
  const int quarters = static_cast<int>(n) & 3;
  const double difference = x - n * parts[0];
  const double rest = difference - n * all_but_first;
  if (std::abs(rest) > near) return {quarters, {rest, (difference - rest) - n * all_but_first}};

  const DoubleDouble first = exact_sum(difference, -n * parts[1]);
  const DoubleDouble second = exact_sum(first.high, -n * parts[2]);
  return {quarters, fast_sum(second.high, (second.low + first.low) - n * parts[3])};
}

/// A binary fraction of 192 bits; the most significant word is last.
using Fraction = std::array<std::uint64_t, 3>;

/// Returns the fractional part of 2/pi times 2^exponent, for exponents from -64 to 1024.
Fraction part_of_two_over_pi(int exponent) {
  constexpr std::array<std::uint64_t, 21> words = {0,
                                                   0xa2f9836e4e441529,
                                                   0xfc2757d1f534ddc0,
                                                   0xdb6295993c439041,
                                                   0xfe5163abdebbc561,
                                                   0xb7246e3a424dd2e0,
                                                   0x06492eea09d1921c,
                                                   0xfe1deb1cb129a73e,
                                                   0xe88235f52ebb4484,
                                                   0xe99c7026b45f7e41,
                                                   0x3991d639835339f4,
                                                   0x9c845f8bbdf9283b,
                                                   0x1ff897ffde05980f,
                                                   0xef2f118b5a0a6d1f,
                                                   0x6d367ecf27cb09b7,
                                                   0x4f463f669e5fea2d,
                                                   0x7527bac7ebe5f17b,
                                                   0x3d0739f78a5292ea,
                                                   0x6bfb5fb11f8d5d08,
                                                   0x56033046fc7b6bab,
                                                   0xf0cfbc209af4361d};
  const auto first = static_cast<unsigned>(exponent + 64);
  const std::size_t word = first / 64;
  const unsigned shift = first % 64;
  Fraction part;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t next = shift == 0 ? 0 : words[word + i + 1] >> (64 - shift);
    part[2 - i] = (words[word + i] << shift) | next;
  }
  return part;
}

Fraction part_below_1_of_product(std::uint64_t factor, const Fraction& fraction) {
  __extension__ using Wide = unsigned __int128;
  Fraction product;
  Wide carry = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    carry += static_cast<Wide>(factor) * fraction[i];
    product[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64U;
  }
  return product;
}

/// Converts a fraction in [0, 1) to [-1/2, 1/2). The ones' complement differs from the negative
/// number by one in the last bit.
DoubleDouble signed_value(const Fraction& fraction) {
  const bool is_negative = fraction[2] >> 63U != 0;
  DoubleDouble sum;
  for (std::size_t half = 0; half < 6; ++half) {
    const std::uint64_t word = is_negative ? ~fraction[half / 2] : fraction[half / 2];
    const auto digits = static_cast<double>(half % 2 == 0 ? word & 0xffffffffU : word >> 32U);
    sum = DoubleDouble{std::ldexp(digits, 32 * static_cast<int>(half) - 192), 0} + sum;
  }
  return is_negative ? -sum : sum;
}

// Reduces large angles (Payne & Hanek). The angle x is an integer times 2^exponent, and the bits of
// 2/pi that contribute only whole turns are skipped.
ReducedAngle reduced_by_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t integer = (bits & 0xfffffffffffffU) | 0x10000000000000U;
  const int exponent = static_cast<int>((bits >> 52U) & 0x7ffU) - 1075;
  const Fraction turns = part_below_1_of_product(integer, part_of_two_over_pi(exponent - 2));
  const int quarters = static_cast<int>((turns[2] + 0x2000000000000000U) >> 62U);
  const DoubleDouble rest = signed_value(part_below_1_of_product(4, turns)) * half_pi;
  return x < 0 ? ReducedAngle{-quarters & 3, -rest} : ReducedAngle{quarters, rest};
}

}  // namespace

ReducedAngle reduced_angle(double x) {
  return std::abs(x) < least_large ? reduced_by_parts(x) : reduced_by_bits(x);
}

}  // namespace transformesh::elementary
