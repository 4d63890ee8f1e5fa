/// The bytes of an input file, with the name of the file for error messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace transformesh {

struct Source {
  std::string_view bytes;
  std::string name;
  /// True: content that a lenient reader would drop or skip with a warning is an error.
  bool is_strict = false;
  /// True: readers number the triangles of each polygon (merge_polygons.h).
  bool keeps_polygons = false;

  const char* begin() const { return bytes.data(); }
  const char* end() const { return bytes.data() + bytes.size(); }

  /// Returns the number of the line that contains `place`, counted from 1.
  std::size_t line_of(const char* place) const;

  /// The three functions throw InputError with the text `what (name)`, `what (name line 12)` and
  /// `what (name byte 1034)`.
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at_line(const char* place, const std::string& what) const;
  [[noreturn]] void fail_at_byte(const char* place, const std::string& what) const;
};

/// Prepares text of the input for a message: quoted, shortened, unprintable bytes as \xNN.
std::string in_quotes(std::string_view text);

}  // namespace transformesh
