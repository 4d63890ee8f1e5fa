/// Conversion between numbers and text, independent of the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace transformesh {

/// Parses the whole text as a number. For integers, a base such as 16 may be given. Returns nothing
/// if the text, or a part of it, is not a number.
template <typename Number, typename... Base>
std::optional<Number> number_in(std::string_view text, Base... base) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number, base...);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

/// Returns the shortest decimal text that reads back as the same double.
std::string shortest_text(double value);
/// Formats like printf's %g with `digits` significant digits.
std::string significant(double value, int digits);
/// Formats like printf's %f with `decimals` decimals.
std::string fixed(double value, int decimals);
/// Parses a number that significant() or fixed() wrote. Returns 0 for other text.
inline double read_back(const std::string& text) { return number_in<double>(text).value_or(0); }

}  // namespace transformesh
