/// Numbers as text: independent of the locale, shortest that reads back the same.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace transformesh {

enum class Parsed { ok, malformed, out_of_range };

/// Whether the magnitude of a decimal number, well formed, is below 1.
bool is_below_one(std::string_view number);

/// Reads the number at the start of [first, last) and moves `first` behind it. Takes a plus sign.
/// Floating point takes nan and inf too; what is too small becomes zero, what is too large is
/// out_of_range.
template <class T>
Parsed parse_number(const char*& first, const char* last, T& value) {
  const char* start = first;
  if (start != last && *start == '+' && start + 1 != last && start[1] != '-') ++start;
  value = T{};
  const auto [rest, error] = std::from_chars(start, last, value);
  if (error == std::errc::invalid_argument) return Parsed::malformed;
  first = rest;
  if constexpr (std::is_floating_point_v<T>) {
    if (error == std::errc::result_out_of_range) {
      const std::string_view text(start, static_cast<std::size_t>(rest - start));
      return is_below_one(text) ? Parsed::ok : Parsed::out_of_range;
    }
  }
  return error == std::errc() ? Parsed::ok : Parsed::out_of_range;
}

/// Text that grows by appending; `take` hands it over.
class TextBuffer {
 public:
  explicit TextBuffer(std::size_t expected_size = 0) { grow(expected_size); }

  void add(char c) {
    ensure(1);
    *end_++ = c;
  }
  void add(std::string_view text) {
    ensure(text.size());
    end_ = text.copy(end_, text.size()) + end_;
  }
  /// Integers as they are, float and double as the shortest text that reads back as the same.
  template <class T>
  void add_number(T value) {
    ensure(longest_number);
    end_ = std::to_chars(end_, end_ + longest_number, value).ptr;
  }
  /// As add_number, with a point or an exponent even where the value is whole.
  void add_decimal(double value) {
    const auto start = static_cast<std::size_t>(end_ - text_.data());
    add_number(value);
    const std::string_view written(text_.data() + start,
                                   static_cast<std::size_t>(end_ - text_.data()) - start);
    if (written.find_first_of(".en") == std::string_view::npos) add(".0");
  }
  std::string take() {
    text_.resize(static_cast<std::size_t>(end_ - text_.data()));
    return std::move(text_);
  }

 private:
  static constexpr std::size_t longest_number = 32;

  void ensure(std::size_t size) {
    if (static_cast<std::size_t>(text_.data() + text_.size() - end_) < size) grow(size);
  }
  void grow(std::size_t size) {
    const std::size_t used = end_ ? static_cast<std::size_t>(end_ - text_.data()) : 0;
    text_.resize(used + size + used / 2 + 4096);
    end_ = text_.data() + used;
  }

  std::string text_;
  char* end_ = nullptr;
};

/// Appends one line for each comment: the mark, a space, the text.
void add_comments(std::string_view mark, const std::vector<std::string>& comments,
                  TextBuffer& text);

}  // namespace transformesh
