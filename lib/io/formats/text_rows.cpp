#include "io/formats/text_rows.h"

#include <algorithm>
#include <cstring>

namespace transformesh {

bool is_number(std::string_view word) {
  const char* first = word.data();
  const char* last = first + word.size();
  double value = 0;
  return parse_number(first, last, value) == Parsed::ok && first == last;
}

TextRows::TextRows(const Source& source, std::size_t start, Rules rules)
    : source_(&source),
      rules_(rules),
      terminator_(source.bytes.find('\n') == std::string_view::npos ? '\r' : '\n'),
      place_(source.begin() + start),
      next_(place_),
      row_end_(place_),
      line_end_(place_) {}

bool TextRows::next_row() {
  while (line_end_ != source_->end()) {
    next_ = place_ = line_end_;
    find_row();
    if (has_more()) {
      place_ = next_;
      return true;
    }
  }
  place_ = source_->end();
  return false;
}

std::string_view TextRows::word() {
  if (has_more()) place_ = next_;
  const char* first = next_;
  next_ = word_end(first);
  return {first, static_cast<std::size_t>(next_ - first)};
}

std::string_view TextRows::peek() const {
  const char* first = word_start(next_);
  return {first, static_cast<std::size_t>(word_end(first) - first)};
}

std::size_t TextRows::words_left() const {
  std::size_t count = 0;
  const char* place = word_start(next_);
  for (; place != row_end_; place = word_start(word_end(place))) ++count;
  return count;
}

std::string_view TextRows::skip_row() {
  const char* first = word_start(next_);
  const char* last = row_end_;
  while (last != first && is_blank(last[-1])) --last;
  next_ = row_end_;
  return {first, static_cast<std::size_t>(last - first)};
}

std::string_view TextRows::last_word() const {
  return {place_, static_cast<std::size_t>(next_ - place_)};
}

const char* TextRows::word_end(const char* from) const {
  while (from != row_end_ && !separates(*from)) ++from;
  return from;
}

const char* TextRows::find_line_end(const char* from) const {
  const auto size = static_cast<std::size_t>(source_->end() - from);
  const void* found = std::memchr(from, terminator_, size);
  return found ? static_cast<const char*>(found) + 1 : source_->end();
}

/// Returns the start of the comment in a line. The mark # in `1.#QNAN`, a text for NaN, does not
/// start a comment.
const char* TextRows::find_comment(const char* start) const {
  const char* mark = std::find(start, line_end_, rules_.comment);
  while (mark != line_end_ && mark != start && mark[-1] == '.' &&
         special_ending(mark, line_end_) > 0)
    mark = std::find(mark + 1, line_end_, rules_.comment);
  return mark;
}

/// Finds the next row, which is a line without its comment. A backslash at the end of a line joins
/// it with the next line, but not inside a comment.
void TextRows::find_row() {
  line_end_ = next_;
  for (;;) {
    const char* start = line_end_;
    line_end_ = row_end_ = find_line_end(start);
    if (rules_.comment != '\0') {
      const char* mark = find_comment(start);
      if (mark != line_end_) return keep_comment(mark);
    }
    if (!rules_.backslash_joins || line_end_ == source_->end()) return;
    const char* last = line_end_ - 1;
    while (last != start && is_blank(*last)) --last;
    if (*last != '\\') return;
  }
}

void TextRows::keep_comment(const char* mark) {
  row_end_ = mark;
  if (has_more()) {
    ++trailing_comments;
    return;
  }
  const char* first = mark + 1;
  const char* last = line_end_;
  while (last != first && (last[-1] == '\n' || last[-1] == '\r')) --last;
  if (first != last && *first == ' ') ++first;
  comments.emplace_back(first, last);
}

void TextRows::fail_rest(const std::string& row) {
  fail(row + " has more values than it should, beginning with " + in_quotes(word()));
}

void TextRows::fail_number(const std::string& what, const char* needed, Parsed problem) {
  next_ = place_;
  const std::string text = in_quotes(word());
  if (problem == Parsed::out_of_range) fail(what + " is out of range: " + text);
  fail(what + " is not " + needed + ": " + text);
}

}  // namespace transformesh
