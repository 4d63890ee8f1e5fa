/// A memory-mapped file, for files larger than memory. The system can drop its pages at any time,
/// so they do not count as memory of the process. release() nevertheless limits the number of pages
/// in memory.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

class MappedFile {
 public:
  /// Throws InputError if the path is not a regular file or cannot be read.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }
  /// Releases the pages if mapped files occupy more than 256 MB of this process.
  void release() const;

 private:
  std::string_view bytes_;
};

}  // namespace transformesh
