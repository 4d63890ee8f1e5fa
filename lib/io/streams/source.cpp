#include "io/streams/source.h"

#include <algorithm>

#include "transformesh/errors.h"

namespace transformesh {

void Source::fail(const std::string& what) const { throw InputError(what + " (" + name + ")"); }

std::size_t Source::line_of(const char* place) const {
  // Files of old Macintoshes end lines with a carriage return only.
  const char line_end = bytes.find('\n') == std::string_view::npos ? '\r' : '\n';
  return 1 + static_cast<std::size_t>(std::count(begin(), place, line_end));
}

void Source::fail_at_line(const char* place, const std::string& what) const {
  throw InputError(what + " (" + name + " line " + std::to_string(line_of(place)) + ")");
}

void Source::fail_at_byte(const char* place, const std::string& what) const {
  throw InputError(what + " (" + name + " byte " + std::to_string(place - begin()) + ")");
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;  // number of bytes shown, so that a message fits on a line
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "'";
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
    }
  }
  return result + (text.size() > longest ? "...'" : "'");
}

}  // namespace transformesh
