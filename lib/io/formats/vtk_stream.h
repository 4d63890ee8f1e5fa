/// Reads the words and blocks of numbers of a legacy VTK file.
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

  /// Returns the next word in lower case; empty at the end of the file.
  std::string word();
  /// Returns the next word, with upper and lower case as in the file.
  std::string_view raw_word();
  /// True if the current line has another word.
  bool has_word_in_line() const;
  /// Returns the rest of the current line, and moves to the next line.
  std::string_view line();
  /// Reads a word that must be a nonnegative integer. Throws InputError otherwise; `what` names the
  /// value in the message.
  std::uint64_t count(const std::string& what);
  void set_binary(bool is_binary) { is_binary_ = is_binary; }
  bool is_binary() const { return is_binary_; }

  /// Reads `count` numbers of a type such as `float`, and stores type and values in `array`. In
  /// binary files the numbers are big-endian and start in the next line. Throws InputError if the
  /// data ends too early.
  void numbers(const std::string& type, std::uint64_t count, VtkArray& array);
  /// Reads nonnegative integers as numbers() does.
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
