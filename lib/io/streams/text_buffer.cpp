#include "io/streams/text_buffer.h"

#include <algorithm>

namespace transformesh {
namespace {

/// True for line ends, which would end a comment, and for control bytes, which would make the file
/// seem binary.
bool is_blanked(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < '\t' || byte == '\n' || byte == '\r';
}

}  // namespace

void TextBuffer::add_decimal(double value) {
  const auto start = static_cast<std::size_t>(end_ - text_.data());
  add_number(value);
  const std::string_view written(text_.data() + start,
                                 static_cast<std::size_t>(end_ - text_.data()) - start);
  if (written.find_first_of(".en") == std::string_view::npos) add(".0");
}

std::string TextBuffer::take() {
  text_.resize(static_cast<std::size_t>(end_ - text_.data()));
  return std::move(text_);
}

void TextBuffer::grow(std::size_t size) {
  const std::size_t used = end_ ? static_cast<std::size_t>(end_ - text_.data()) : 0;
  text_.resize(used + size + used / 2 + 4096);
  end_ = text_.data() + used;
}

std::string as_comment(std::string comment) {
  std::replace_if(comment.begin(), comment.end(), is_blanked, ' ');
  return comment;
}

void add_comments(std::string_view mark, const std::vector<std::string>& comments,
                  TextBuffer& text) {
  for (const std::string& comment : comments) {
    text.add(mark);
    if (!comment.empty()) text.add(' ');
    text.add(as_comment(comment));
    text.add('\n');
  }
}

}  // namespace transformesh
