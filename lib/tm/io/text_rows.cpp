#include "tm/io/text_rows.h"

#include <algorithm>
#include <cstring>

namespace transformesh {

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
    line_end_ = row_end_ = find_line_end(next_);
    if (rules_.comment != '\0') cut_comment();
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
  while (next_ != row_end_ && !is_blank(*next_)) ++next_;
  return {first, static_cast<std::size_t>(next_ - first)};
}

std::size_t TextRows::words_left() const {
  TextRows rest(*this);
  std::size_t count = 0;
  while (!rest.word().empty()) ++count;
  return count;
}

std::string_view TextRows::skip_row() {
  skip_blanks();
  const char* first = next_;
  const char* last = row_end_;
  while (last != first && is_blank(last[-1])) --last;
  next_ = row_end_;
  return {first, static_cast<std::size_t>(last - first)};
}

std::string_view TextRows::last_word() const {
  return {place_, static_cast<std::size_t>(next_ - place_)};
}

void TextRows::fail_rest(const std::string& row) {
  fail(row + " has more values than it should, beginning with " + quoted(word()));
}

const char* TextRows::find_line_end(const char* from) const {
  const char* end = source_->end();
  while (from != end) {
    const void* found = std::memchr(from, terminator_, static_cast<std::size_t>(end - from));
    if (!found) return end;
    const char* last = static_cast<const char*>(found);
    from = last + 1;
    if (!rules_.backslash_joins) break;
    if (last != source_->begin() && last[-1] == '\r') --last;
    if (last == source_->begin() || last[-1] != '\\') break;
  }
  return from;
}

void TextRows::cut_comment() {
  const char* mark = std::find(next_, line_end_, rules_.comment);
  if (mark == line_end_) return;
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

void TextRows::fail_number(const std::string& what, Parsed problem) {
  if (!has_more() && problem == Parsed::malformed) fail(what + " is missing");
  next_ = place_;
  const std::string text = quoted(word());
  if (problem == Parsed::out_of_range) fail(what + " is out of range: " + text);
  fail(what + " is not a number of the kind needed: " + text);
}

}  // namespace transformesh
