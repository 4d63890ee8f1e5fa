#include "tm/evolution/csv_row.h"

#include <array>
#include <charconv>

namespace transformesh {
namespace {

std::string converted(double value, std::chars_format format, int precision) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
  return {text.data(), end.ptr};
}

}  // namespace

std::string significant(double value, int digits) {
  return converted(value, std::chars_format::general, digits);
}

std::string fixed(double value, int decimals) {
  return converted(value, std::chars_format::fixed, decimals);
}

double read_back(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace transformesh
