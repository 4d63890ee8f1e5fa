/// Bytes from and to files, pipes and terminals. Nothing seeks and nothing trusts a file size.
#pragma once

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace transformesh {

/// A block of bytes that grows without being cleared or, where it is large, copied.
class Bytes {
 public:
  /// Room for `size` more bytes after the present ones; throws std::bad_alloc.
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

/// All of a file, or of stdin for `-`. Throws InputError.
Bytes read_all(const std::string& path);

/// What messages call an input.
std::string input_name(const std::string& path);

/// The folder of a file that is given by its name, `.` for one here. Empty for `-`, and for what is
/// no regular file.
std::string input_folder(const std::string& path);

/// Writes all bytes; false with errno set on failure.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace transformesh
