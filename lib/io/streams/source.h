/// The bytes of an input, and its name in messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace transformesh {

struct Source {
  std::string_view bytes;
  std::string name;
  /// True: content that is otherwise dropped or skipped with a note is an error.
  bool is_strict = false;
  bool keeps_polygons = false;  ///< true: the triangles of polygons are numbered (merge_polygons.h)

  const char* begin() const { return bytes.data(); }
  const char* end() const { return bytes.data() + bytes.size(); }

  /// Returns the line of a place, counted from 1.
  std::size_t line_of(const char* place) const;

  /// Throw InputError: `what (name)`, `what (name line 12)`, `what (name byte 1034)`.
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at_line(const char* place, const std::string& what) const;
  [[noreturn]] void fail_at_byte(const char* place, const std::string& what) const;
};

/// Prepares text of the input for a message: quoted, shortened, unprintable bytes as \xNN.
std::string quoted(std::string_view text);

}  // namespace transformesh
