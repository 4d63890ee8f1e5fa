#include "io/streams/number_text.h"

#include <algorithm>

namespace transformesh {

bool is_below_one(std::string_view number) {
  // An exponent that overflows an int decides alone: the number is below 1 if the exponent is
  // negative. No number has enough digits to compensate for it.
  const std::size_t exponent_mark = number.find_first_of("eE");
  int exponent = 0;
  if (exponent_mark != std::string_view::npos) {
    const char* first = number.data() + exponent_mark + 1;
    const bool negative = *first == '-';
    if (parse_number(first, number.data() + number.size(), exponent) != Parsed::ok) return negative;
  }

  // Otherwise the number is below 1 if its first nonzero digit is behind the point after shifting
  // by the exponent.
  const std::string_view digits = number.substr(0, exponent_mark);
  const std::size_t first_digit = digits.find_first_of("123456789");
  if (first_digit == std::string_view::npos) return true;
  const auto point = static_cast<long>(std::min(digits.find('.'), digits.size()));
  const long place = point - static_cast<long>(first_digit);
  return place + exponent <= 0;
}

std::size_t special_ending(const char* first, const char* last) {
  const std::string_view text(first, static_cast<std::size_t>(last - first));
  for (const std::string_view ending : {"#QNAN", "#SNAN", "#IND", "#INF"}) {
    if (!text.starts_with(ending)) continue;
    return std::min(text.find_first_not_of("0123456789", ending.size()), text.size());
  }
  return 0;
}

}  // namespace transformesh
