/// Words and blocks of numbers of a legacy VTK file, in turn.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/formats/vtk_data.h"
#include "io/streams/source.h"

namespace transformesh {

class VtkStream {
 public:
  explicit VtkStream(const Source& source) : source_(&source), place_(source.begin()) {}

  /// The next word in lower case; empty at the end.
  std::string word();
  /// The next word as it is.
  std::string_view raw_word();
  /// True if the line has a further word.
  bool has_word_in_line() const;
  /// The rest of the line, and moves behind it.
  std::string_view line();
  /// A word that is a whole number. Throws InputError.
  std::uint64_t count(const std::string& what);
  void set_binary(bool is_binary) { is_binary_ = is_binary; }
  bool is_binary() const { return is_binary_; }

  /// Reads numbers of a type such as `float`, big-endian from the next line on if the file is
  /// binary, and sets type and values of `array`. Throws InputError if they are not all there.
  void numbers(const std::string& type, std::uint64_t count, VtkArray& array);
  /// The same for whole numbers of 0 or more.
  std::vector<std::uint64_t> indices(const std::string& type, std::uint64_t count,
                                     const std::string& what);

  [[noreturn]] void fail(const std::string& what) const { source_->fail_at_byte(place_, what); }

 private:
  void skip_blanks();
  void read_text(std::uint64_t count, VtkArray& array);
  template <class T>
  void read_bytes(std::uint64_t count, VtkArray& array);

  const Source* source_;
  const char* place_;
  bool is_binary_ = false;
};

}  // namespace transformesh
