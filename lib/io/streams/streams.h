/// Bytes from and to files, pipes and terminals. Only named regular files are read by several
/// threads; no function relies on a file size.
#pragma once

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace transformesh {

/// A buffer that grows without being zeroed, and without being copied if it is large.
class Bytes {
 public:
  /// Returns room for `size` more bytes after the present bytes. Throws std::bad_alloc.
  char* reserve(std::size_t size);
  void grow(std::size_t size) { size_ += size; }
  std::string_view view() const { return {data_.get(), size_}; }

 private:
  struct Free {
    void operator()(char* data) const { std::free(data); }
  };
  std::unique_ptr<char, Free> data_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// Reads a whole file, or stdin for `-`. Throws InputError.
Bytes read_all(const std::string& path);

/// Returns the name of an input in messages.
std::string input_name(const std::string& path);

/// Returns the folder of a regular file, `.` if the path has none. Returns an empty name for `-`
/// and for other kinds of paths.
std::string input_folder(const std::string& path);

/// Writes all bytes. Returns false, with errno set, on failure.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace transformesh
