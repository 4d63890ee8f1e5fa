/// Numbers as text and back, independent of the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace transformesh {

/// The whole text as a number, of integers in the base given; nothing where it is none.
template <typename Number, typename... Base>
std::optional<Number> number_in(std::string_view text, Base... base) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number, base...);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

/// The shortest decimal text that reads back as the same double.
std::string shortest_text(double value);
/// As printf's %g with so many significant digits.
std::string significant(double value, int digits);
/// As printf's %f with so many decimals.
std::string fixed(double value, int decimals);
/// The number that one of these wrote.
inline double read_back(const std::string& text) { return number_in<double>(text).value_or(0); }

}  // namespace transformesh
