/// Numbers as text: independent of the locale, shortest that reads back the same.
#pragma once

#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace transformesh {

enum class Parsed { ok, malformed, out_of_range };

/// Whether the magnitude of a decimal number, well formed, is below 1.
bool is_below_one(std::string_view number);

/// Length of the ending that older C libraries of Microsoft write behind `1.` for NaN and infinity:
/// `#QNAN`, `#SNAN`, `#IND` or `#INF`, perhaps with digits. 0 if [first, last) does not start with
/// it.
std::size_t special_ending(const char* first, const char* last);

/// Reads the number at the start of [first, last) and moves `first` behind it. Takes a plus sign.
/// Floating point takes nan and inf too, also as `1.#QNAN` and `1.#INF`, which both become NaN;
/// what is too small becomes zero, what is too large is out_of_range.
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
