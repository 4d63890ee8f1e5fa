/// The eight PLY scalar types as values, names and bytes.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

#include "transformesh/columns.h"

namespace transformesh {

/// Calls f with a zero of the C++ type of `type`, and returns the result of f.
template <class Function>
decltype(auto) with_scalar(Scalar type, Function&& f) {
  switch (type) {
    case Scalar::int8:
      return f(std::int8_t{});
    case Scalar::uint8:
      return f(std::uint8_t{});
    case Scalar::int16:
      return f(std::int16_t{});
    case Scalar::uint16:
      return f(std::uint16_t{});
    case Scalar::int32:
      return f(std::int32_t{});
    case Scalar::uint32:
      return f(std::uint32_t{});
    case Scalar::float32:
      return f(float{});
    default:
      return f(double{});
  }
}

inline std::size_t byte_size(Scalar type) {
  return with_scalar(type, [](auto zero) { return sizeof(zero); });
}

inline bool is_floating(Scalar type) { return type == Scalar::float32 || type == Scalar::float64; }

/// Returns the PLY name of a type, such as `uchar`. If `sized` is set, returns the name with its
/// size, such as `uint8`.
std::string_view scalar_name(Scalar type, bool sized);
/// Returns the type with this PLY name, such as `uchar` or `uint8`. Returns nothing for other
/// words.
std::optional<Scalar> scalar_of_name(std::string_view name);

/// Returns the integer type `type` if it can represent `largest`, else the narrowest wider type
/// that can.
Scalar widened(Scalar type, std::uint64_t largest);

/// Converts a number to the nearest value of type T. For integers, it is rounded and clamped, and
/// NaN becomes 0.
template <class T>
T to_scalar(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    constexpr auto smallest = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto largest = static_cast<double>(std::numeric_limits<T>::max());
    if (!(value > smallest)) return value <= smallest ? std::numeric_limits<T>::min() : T{};
    return value >= largest ? std::numeric_limits<T>::max() : static_cast<T>(std::round(value));
  }
}

}  // namespace transformesh
