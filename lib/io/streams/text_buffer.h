/// Text that grows by appending words and numbers, fast: numbers are formatted in place.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace transformesh {

class TextBuffer {
 public:
  TextBuffer() { grow(0); }

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
  void add_decimal(double value);
  /// Hands the text over.
  std::string take();

 private:
  static constexpr std::size_t longest_number = 32;

  void ensure(std::size_t size) {
    if (static_cast<std::size_t>(text_.data() + text_.size() - end_) < size) grow(size);
  }
  void grow(std::size_t size);

  std::string text_;
  char* end_ = nullptr;
};

/// Appends one line for each comment: the mark, a space, the text, with blanks for line ends and
/// for bytes below the tab.
void add_comments(std::string_view mark, const std::vector<std::string>& comments,
                  TextBuffer& text);

}  // namespace transformesh
