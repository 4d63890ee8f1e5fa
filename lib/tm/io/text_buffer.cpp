#include "tm/io/text_buffer.h"

namespace transformesh {

void add_comments(std::string_view mark, const std::vector<std::string>& comments,
                  TextBuffer& text) {
  for (const std::string& comment : comments) {
    text.add(mark);
    if (!comment.empty()) text.add(' ');
    for (const char c : comment) text.add(c == '\n' || c == '\r' ? ' ' : c);
    text.add('\n');
  }
}

}  // namespace transformesh
