/// Numbers as text: independent of the locale, shortest that reads back the same.
#pragma once

#include <charconv>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace transformesh {

enum class Parsed { ok, malformed, out_of_range };

/// Whether the magnitude of a decimal number, well formed, is below 1.
bool is_below_one(std::string_view number);

/// Reads the number at the start of [first, last) and moves `first` behind it. Takes a plus sign.
/// Floating point takes nan and inf too; what is too small becomes zero, what is too large is
/// out_of_range.
template <class T>
Parsed parse_number(const char*& first, const char* last, T& value) {
  const char* start = first;
  if (start != last && *start == '+' && start + 1 != last && start[1] != '-') ++start;
  value = T{};
  const auto [rest, error] = std::from_chars(start, last, value);
  if (error == std::errc::invalid_argument) return Parsed::malformed;
  first = rest;
  if constexpr (std::is_floating_point_v<T>) {
    if (error == std::errc::result_out_of_range) {
      const std::string_view text(start, static_cast<std::size_t>(rest - start));
      return is_below_one(text) ? Parsed::ok : Parsed::out_of_range;
    }
  }
  return error == std::errc() ? Parsed::ok : Parsed::out_of_range;
}

}  // namespace transformesh
