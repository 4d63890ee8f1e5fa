/// Text that grows by words and numbers. Numbers are formatted in place, which is fast.
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
  /// Appends an integer, or a float or double as the shortest text that reads back as the same
  /// value.
  template <class T>
  void add_number(T value) {
    ensure(longest_number);
    end_ = std::to_chars(end_, end_ + longest_number, value).ptr;
  }
  /// Does the same as add_number(), but with a point or an exponent even for whole numbers.
  void add_decimal(double value);
  /// Returns the text and empties the buffer.
  std::string take();

 private:
  /// Room for a number, in bytes. The shortest text of a double has at most 24 bytes.
  static constexpr std::size_t longest_number = 32;

  void ensure(std::size_t size) {
    if (static_cast<std::size_t>(text_.data() + text_.size() - end_) < size) grow(size);
  }
  void grow(std::size_t size);

  std::string text_;
  char* end_ = nullptr;
};

/// Returns a comment as it is written: line ends and bytes below the tab become blanks.
std::string as_comment(std::string comment);

/// Appends one line for each comment: the mark, a space, and as_comment().
void add_comments(std::string_view mark, const std::vector<std::string>& comments,
                  TextBuffer& text);

}  // namespace transformesh
