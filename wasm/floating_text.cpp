/// Floating-point numbers as text and back, with the bytes of libstdc++'s std::to_chars. Digits are
/// those of double-conversion (shortest, closest to the number); reading is by fast_float, which
/// libstdc++ uses too.
#include <double-conversion/double-conversion.h>
#include <fast_float/fast_float.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace std {
namespace {

using Converter = double_conversion::DoubleToStringConverter;

to_chars_result written(char* first, char* last, string_view text) {
  if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
  return {text.copy(first, text.size()) + first, errc()};
}

string special_text(double value) {
  return string(signbit(value) ? "-" : "") + (isnan(value) ? "nan" : isinf(value) ? "inf" : "0");
}

/// All digits of a whole number, also those past the shortest ones.
string whole_text(double magnitude) {
  array<char, 400> text;
  return {text.data(), static_cast<size_t>(snprintf(text.data(), text.size(), "%.0f", magnitude))};
}

/// `point` is the number of digits before the point.
string fixed_text(const string& digits, int point, double magnitude) {
  const int count = static_cast<int>(digits.size());
  if (point >= count) return whole_text(magnitude);
  if (point <= 0) return "0." + string(static_cast<size_t>(-point), '0') + digits;
  return digits.substr(0, static_cast<size_t>(point)) + '.' +
         digits.substr(static_cast<size_t>(point));
}

string scientific_text(const string& digits, int exponent) {
  string text = digits.substr(0, 1);
  if (digits.size() > 1) text += '.' + digits.substr(1);
  const string size = to_string(abs(exponent));
  return text + (exponent < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" : "") + size;
}

template <class Number>
to_chars_result shortest(char* first, char* last, Number number, Converter::DtoaMode mode) {
  if (!isfinite(number) || number == 0) return written(first, last, special_text(number));
  array<char, 32> buffer;
  bool is_negative = false;
  int count = 0, point = 0;
  Converter::DoubleToAscii(number, mode, 0, buffer.data(), static_cast<int>(buffer.size()),
                           &is_negative, &count, &point);
  const string digits(buffer.data(), static_cast<size_t>(count));
  const int exponent = point - count;  // exponent of the last digit
  const bool has_point = count > 1;
  const bool is_fixed =
      exponent <= (has_point ? 5 : 4) && exponent >= -(count + 3) + (has_point ? 0 : 1);
  return written(first, last,
                 (is_negative ? "-" : "") + (is_fixed ? fixed_text(digits, point, abs(number))
                                                      : scientific_text(digits, point - 1)));
}

bool has_digit_above_zero(const char* first, const char* last) {
  for (; first != last && *first != 'e' && *first != 'E'; ++first)
    if (*first >= '1' && *first <= '9') return true;
  return false;
}

template <class Number>
from_chars_result read(const char* first, const char* last, Number& value) {
  Number number = 0;
  const auto [end, error] = fast_float::from_chars(first, last, number);
  if (error != errc()) return {end, error};
  const bool is_too_large = isinf(number) && has_digit_above_zero(first, end);
  const bool is_too_small = number == 0 && has_digit_above_zero(first, end);
  if (is_too_large || is_too_small) return {end, errc::result_out_of_range};
  value = number;
  return {end, errc()};
}

}  // namespace

to_chars_result to_chars(char* first, char* last, double value) {
  return shortest(first, last, value, Converter::SHORTEST);
}

to_chars_result to_chars(char* first, char* last, float value) {
  return shortest(first, last, value, Converter::SHORTEST_SINGLE);
}

to_chars_result to_chars(char* first, char* last, double value, chars_format format,
                         int precision) {
  array<char, 1200> text;
  const char* pattern = format == chars_format::fixed ? "%.*f" : "%.*g";
  const int size = snprintf(text.data(), text.size(), pattern, precision, value);
  return written(first, last, {text.data(), static_cast<size_t>(size)});
}

from_chars_result from_chars(const char* first, const char* last, double& value) {
  return read(first, last, value);
}

from_chars_result from_chars(const char* first, const char* last, float& value) {
  return read(first, last, value);
}

}  // namespace std
