/// Reads text by rows (lines) and words. Blank lines are skipped.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "io/streams/number_text.h"
#include "io/streams/source.h"

namespace transformesh {

/// True if the whole word is a number.
bool is_number(std::string_view word);

class TextRows {
 public:
  struct Rules {
    char comment = '\0';  ///< character that starts a comment, which extends to the end of the line
    /// True if a backslash at the end of a line joins it with the next line.
    bool backslash_joins = false;
  };

  TextRows(const Source& source, std::size_t start, Rules rules);

  /// Moves to the next row that contains a word. Returns false at the end of the text.
  bool next_row();
  /// True if the row has another unread word.
  bool has_more();
  /// Reads and returns the next word; empty at the end of the row.
  std::string_view word();
  /// Returns the next word without reading it. words_left() returns the number of unread words in
  /// the row.
  std::string_view peek() const;
  std::size_t words_left() const;
  /// Skips the rest of the row, and returns its text without surrounding blanks.
  std::string_view skip_row();
  /// Returns the text of the word or number that was read last.
  std::string_view last_word() const;
  /// Reads the next word as a number. Throws InputError if the word is not a number. what() returns
  /// the name of the value for the message.
  template <class T, class What>
  T number(const What& what);
  /// Reads the next word as a finite number. Throws InputError as number() does, and also if the
  /// number is not finite.
  template <class T, class What>
  T finite_number(const What& what);
  /// Reads the next word as a number. If reading is strict, throws as finite_number() does.
  /// Otherwise returns NaN for a number that is not finite or exceeds the range of T.
  template <class T, class What>
  T number_or_nan(const What& what);
  /// Throws InputError if the row has another unread word. row() returns the name of the row for
  /// the message.
  template <class What>
  void end_row(const What& row) {
    if (has_more()) fail_rest(row());
  }

  /// Returns a position in the text that is not after the start of the next row.
  const char* rest() const { return line_end_; }
  /// Returns the start of the word or number that was read last.
  const char* place() const { return place_; }
  [[noreturn]] void fail(const std::string& what) const { source_->fail_at_line(place_, what); }

  /// Texts of the comment lines read so far, without the comment character and one space after it.
  std::vector<std::string> comments;
  /// Number of comments that follow data in a line. These comments are dropped.
  std::size_t trailing_comments = 0;

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  bool separates(char c) const { return is_blank(c) || (rules_.backslash_joins && c == '\\'); }
  const char* word_start(const char* from) const;
  const char* word_end(const char* from) const;
  const char* find_line_end(const char* from) const;
  void find_row();
  const char* find_comment(const char* start) const;
  void keep_comment(const char* mark);
  [[noreturn]] void fail_rest(const std::string& row);
  [[noreturn]] void fail_number(const std::string& what, const char* needed, Parsed problem);
  template <class T>
  Parsed parse_word(T& value);

  const Source* source_;
  Rules rules_;
  char terminator_;
  const char* place_;     ///< start of the word or number that was read last, for messages
  const char* next_;      ///< start of the unread part of the row
  const char* row_end_;   ///< end of the row, before any comment
  const char* line_end_;  ///< end of the line of text, after any comment
};

/// Rules for text in which # starts a comment.
inline constexpr TextRows::Rules rules_with_comments{'#', false};
/// Rules for text in which no character starts a comment, because names in it may contain #.
inline constexpr TextRows::Rules rules_without_comments{'\0', false};

inline const char* TextRows::word_start(const char* from) const {
  while (from != row_end_ && separates(*from)) ++from;
  return from;
}

inline bool TextRows::has_more() {
  next_ = word_start(next_);
  return next_ != row_end_;
}

template <class T>
Parsed TextRows::parse_word(T& value) {
  place_ = next_;
  const Parsed parsed = parse_number(next_, row_end_, value);
  const bool is_whole_word = next_ == row_end_ || separates(*next_);
  return is_whole_word ? parsed : Parsed::malformed;
}

template <class T, class What>
T TextRows::number(const What& what) {
  constexpr const char* needed = std::is_floating_point_v<T> ? "a number"
                                 : std::is_signed_v<T>       ? "a whole number"
                                                             : "a whole number of 0 or more";
  if (!has_more()) fail(what() + " is missing");
  T value;
  const Parsed parsed = parse_word(value);
  if (parsed != Parsed::ok) fail_number(what(), needed, parsed);
  return value;
}

template <class T, class What>
T TextRows::number_or_nan(const What& what) {
  if (source_->is_strict) return finite_number<T>(what);
  if (!has_more()) fail(what() + " is missing");
  T value;
  const Parsed parsed = parse_word(value);
  if (parsed == Parsed::malformed) fail_number(what(), "a number", parsed);
  const bool is_finite = parsed == Parsed::ok && std::isfinite(value);
  return is_finite ? value : std::numeric_limits<T>::quiet_NaN();
}

template <class T, class What>
T TextRows::finite_number(const What& what) {
  const T value = number<T>(what);
  if (!std::isfinite(value)) fail_number(what(), "a finite number", Parsed::malformed);
  return value;
}

}  // namespace transformesh
