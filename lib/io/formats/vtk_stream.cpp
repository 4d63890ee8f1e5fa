#include "io/formats/vtk_stream.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "io/document/scalar_bytes.h"
#include "io/streams/number_text.h"
#include "support/counted.h"
#include "support/lower_case.h"

namespace transformesh {
namespace {

bool is_white_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Calls f with a zero of the C++ type for the name of a VTK type. Returns false for other names.
template <class Function>
bool with_vtk_type(const std::string& name, const Function& f) {
  if (name == "float") return f(float{}), true;
  if (name == "double") return f(double{}), true;
  if (name == "unsigned_char") return f(std::uint8_t{}), true;
  if (name == "char" || name == "signed_char") return f(std::int8_t{}), true;
  if (name == "unsigned_short") return f(std::uint16_t{}), true;
  if (name == "short") return f(std::int16_t{}), true;
  if (name == "unsigned_int") return f(std::uint32_t{}), true;
  if (name == "int" || name == "vtkidtype") return f(std::int32_t{}), true;
  if (name == "unsigned_long" || name == "vtktypeuint64") return f(std::uint64_t{}), true;
  if (name == "long" || name == "vtktypeint64") return f(std::int64_t{}), true;
  return false;
}

}  // namespace

void VtkStream::skip_blanks() {
  while (place_ != source_->end() && is_white_space(*place_)) ++place_;
}

std::string_view VtkStream::raw_word() {
  skip_blanks();
  const char* first = place_;
  while (place_ != source_->end() && !is_white_space(*place_)) ++place_;
  return {first, static_cast<std::size_t>(place_ - first)};
}

std::string VtkStream::word() { return lower_case(raw_word()); }

bool VtkStream::has_word_in_line() const {
  const char* next = place_;
  while (next != source_->end() && (*next == ' ' || *next == '\t')) ++next;
  return next != source_->end() && *next != '\n' && *next != '\r';
}

std::string_view VtkStream::line() {
  const char* first = place_;
  place_ = std::find(place_, source_->end(), '\n');
  std::string_view text(first, static_cast<std::size_t>(place_ - first));
  if (place_ != source_->end()) ++place_;
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::uint64_t VtkStream::count(const std::string& what) {
  const std::string_view text = raw_word();
  const char* first = text.data();
  const char* last = first + text.size();
  std::uint64_t value = 0;
  if (parse_number(first, last, value) != Parsed::ok || first != last)
    fail(what + " must be a whole number of 0 or more, not " + in_quotes(text));
  return value;
}

void VtkStream::numbers(const std::string& type, std::uint64_t count, VtkArray& array) {
  const auto left = static_cast<std::size_t>(source_->end() - place_);
  const bool is_known = with_vtk_type(type, [&](auto zero) {
    using T = decltype(zero);
    // Least number of bytes of a number. In text, a number takes at least a digit and a blank.
    const std::size_t size = is_binary_ ? sizeof(T) : 2;
    if (count > left / size + 1)
      fail(counted(count, "number") + " of " + in_quotes(array.name) + " are announced, but only " +
           counted(left, "byte") + " follow: the file is cut off or its header is wrong");
    is_binary_ ? read_bytes<T>(count, array) : read_text(count, array);
    set_type(std::is_floating_point_v<T>, std::is_signed_v<T>, sizeof(T), array);
  });
  if (!is_known) fail("numbers of the type " + in_quotes(type) + " are not supported");
}

void VtkStream::read_text(std::uint64_t count, VtkArray& array) {
  array.values.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string_view text = raw_word();
    const char* first = text.data();
    const char* last = first + text.size();
    double value = 0;
    const Parsed parsed = parse_number(first, last, value);
    if (parsed == Parsed::malformed || first != last)
      fail("number " + std::to_string(i) + " of " + in_quotes(array.name) + " is " +
           in_quotes(text));
    array.values.push_back(parsed == Parsed::ok ? value : std::nan(""));
  }
}

/// Reads binary numbers, which start after the end of the current line.
template <class T>
void VtkStream::read_bytes(std::uint64_t count, VtkArray& array) {
  line();
  if (count > static_cast<std::size_t>(source_->end() - place_) / sizeof(T))
    fail("the data ends within the numbers of " + in_quotes(array.name));
  array.values.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    array.values.push_back(static_cast<double>(load_scalar<T>(place_, host_is_little)));
    place_ += sizeof(T);
  }
}

std::vector<std::uint64_t> VtkStream::indices(const std::string& type, std::uint64_t count,
                                              const std::string& what) {
  VtkArray array;
  array.name = what;
  numbers(type, count, array);
  std::vector<std::uint64_t> result;
  result.reserve(array.values.size());
  constexpr double most = 9007199254740992.0;  // 2^53: doubles represent all smaller integers
  for (const double value : array.values) {
    if (!(value >= 0 && value <= most) || value != std::floor(value))
      fail(what + " has an index that is not a whole number of 0 or more");
    result.push_back(static_cast<std::uint64_t>(value));
  }
  return result;
}

}  // namespace transformesh
