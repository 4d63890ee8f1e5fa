/// The bytes being read and the name that messages give them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace transformesh {

struct Source {
  std::string_view bytes;
  std::string name;
  bool is_strict = false;  ///< refuses what is else dropped or skipped with a count

  const char* begin() const { return bytes.data(); }
  const char* end() const { return bytes.data() + bytes.size(); }

  /// Counted from 1.
  std::size_t line_of(const char* place) const;

  /// Each throws InputError: `what (name)`, `what (name line 12)`, `what (name byte 1034)`.
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at_line(const char* place, const std::string& what) const;
  [[noreturn]] void fail_at_byte(const char* place, const std::string& what) const;
};

/// Text taken from the input, fit for a message: quoted, shortened, unprintable bytes as \xNN.
std::string quoted(std::string_view text);

}  // namespace transformesh
