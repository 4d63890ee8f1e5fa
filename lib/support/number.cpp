#include "support/number.h"

#include <array>

namespace transformesh {
namespace {

template <typename... Format>
std::string converted(double value, Format... format) {
  std::array<char, 400> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, format...).ptr};
}

}  // namespace

std::string shortest_text(double value) { return converted(value); }

std::string significant(double value, int digits) {
  return converted(value, std::chars_format::general, digits);
}

std::string fixed(double value, int decimals) {
  return converted(value, std::chars_format::fixed, decimals);
}

}  // namespace transformesh
