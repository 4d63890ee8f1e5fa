/// Conversion of numbers to and from text, independent of the locale. A number becomes the shortest
/// text that reads back as the same value.
#pragma once

#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace transformesh {

enum class Parsed { ok, malformed, out_of_range };

/// True if the magnitude of a well-formed decimal number is below 1.
bool is_below_one(std::string_view number);

/// Returns the length of the ending that old Microsoft C libraries write after `1.` for NaN and
/// infinity: `#QNAN`, `#SNAN`, `#IND` or `#INF`, optionally followed by digits. Returns 0 if
/// [first, last) does not start with such an ending.
std::size_t special_ending(const char* first, const char* last);

/// Parses the number at the start of [first, last) and moves `first` past it. Accepts a plus sign.
/// Floating-point types also accept nan and inf, and `1.#QNAN` and `1.#INF`, both of which become
/// NaN. Underflow becomes zero; overflow returns out_of_range.
template <class T>
Parsed parse_number(const char*& first, const char* last, T& value) {
  const char* start = first;
  if (start != last && *start == '+' && start + 1 != last && start[1] != '-') ++start;
  value = T{};
  const auto [rest, error] = std::from_chars(start, last, value);
  if (error == std::errc::invalid_argument) return Parsed::malformed;
  first = rest;
  if constexpr (std::is_floating_point_v<T>) {
    if (rest != last && *rest == '#') {
      const std::size_t ending = special_ending(rest, last);
      first += ending;
      if (ending > 0) value = std::numeric_limits<T>::quiet_NaN();
    }
    if (error == std::errc::result_out_of_range) {
      const std::string_view text(start, static_cast<std::size_t>(rest - start));
      return is_below_one(text) ? Parsed::ok : Parsed::out_of_range;
    }
  }
  return error == std::errc() ? Parsed::ok : Parsed::out_of_range;
}

}  // namespace transformesh
