/// Powers of two, and exponents of doubles, by operations on their bits. Many times faster than the
/// functions of the C library.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace transformesh {

/// Returns 2^exponent, or the nearest normal power of two if that is not a normal double.
inline double power_of_two(int exponent) {
  const auto biased = static_cast<std::uint64_t>(std::clamp(exponent, -1022, 1023) + 1023);
  return std::bit_cast<double>(biased << 52U);
}

/// Returns the exponent of the largest power of two that is at most a positive number, clamped to
/// [-1022, 1022]. Then both 2^e and 2^-e are normal doubles.
inline int binary_exponent(double number) {
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(number) >> 52U);
  return std::clamp(biased, 1, 2045) - 1023;
}

}  // namespace transformesh
