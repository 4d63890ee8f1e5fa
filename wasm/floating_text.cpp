/// Floating-point numbers as text, with the bytes of libstdc++'s std::to_chars. Digits are those of
/// double-conversion (shortest, closest to the number).
#include <double-conversion/double-conversion.h>

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

}  // namespace std
