/// Floating-point numbers from text, for versions of libc++ whose std::from_chars reads integers
/// only. fast_float reads as libstdc++ does, which contains it.
#include <fast_float/fast_float.h>

#include <cmath>

#if _LIBCPP_VERSION < 200000

namespace std {
namespace {

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

from_chars_result from_chars(const char* first, const char* last, double& value) {
  return read(first, last, value);
}

from_chars_result from_chars(const char* first, const char* last, float& value) {
  return read(first, last, value);
}

}  // namespace std

#endif
