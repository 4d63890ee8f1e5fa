/// A file whose bytes are read where they are needed, for files larger than memory. The system can
/// drop the pages that hold them at any time, so they do not count as memory of the process; still
/// release() keeps their number small.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

class MappedFile {
 public:
  /// Throws InputError if the path is no regular file or cannot be read.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }
  /// Gives the pages back if this process holds more than 256 MB of any files.
  void release() const;

 private:
  std::string_view bytes_;
};

}  // namespace transformesh
