/// Powers of two and exponents of doubles by their bits, many times as fast as the C library's.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace transformesh {

/// 2^exponent; the nearest power that is a normal number where it is none.
inline double power_of_two(int exponent) {
  const auto biased = static_cast<std::uint64_t>(std::clamp(exponent, -1022, 1023) + 1023);
  return std::bit_cast<double>(biased << 52U);
}

/// The exponent of the largest power of two up to a positive number, but from -1022 to 1022, so
/// that the power of two to its opposite is a number too.
inline int binary_exponent(double number) {
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(number) >> 52U);
  return std::clamp(biased, 1, 2045) - 1023;
}

}  // namespace transformesh
