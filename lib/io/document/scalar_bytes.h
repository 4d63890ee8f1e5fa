/// Loads and stores scalars as bytes of a file, in native or swapped byte order.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace transformesh {

inline constexpr bool host_is_little = std::endian::native == std::endian::little;

template <class T>
T byte_swapped(T value) {
  if constexpr (sizeof(T) == 1) {
    return value;
  } else if constexpr (sizeof(T) == 2) {
    return std::bit_cast<T>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
  } else if constexpr (sizeof(T) == 4) {
    return std::bit_cast<T>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
  } else {
    return std::bit_cast<T>(__builtin_bswap64(std::bit_cast<std::uint64_t>(value)));
  }
}

template <class T>
T load_scalar(const char* from, bool swapped) {
  T value;
  // Swap the bytes as an integer, because copying a float may change the bits of a NaN.
  if constexpr (sizeof(T) == 4) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, from, sizeof(bits));
    return std::bit_cast<T>(swapped ? byte_swapped(bits) : bits);
  } else if constexpr (sizeof(T) == 8) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, from, sizeof(bits));
    return std::bit_cast<T>(swapped ? byte_swapped(bits) : bits);
  } else {
    std::memcpy(&value, from, sizeof(value));
    return swapped ? byte_swapped(value) : value;
  }
}

template <class T>
void store_scalar(char* to, T value, bool swapped) {
  if (swapped) value = byte_swapped(value);
  std::memcpy(to, &value, sizeof(value));
}

}  // namespace transformesh
