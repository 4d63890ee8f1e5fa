/// A file that grows by lines, each of which is one write. What is not a regular file (a FIFO,
/// /dev/stderr, /dev/fd/63) stays open from the first line to the last, so that its reader sees one
/// stream.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

class LineFile {
 public:
  /// With these lines to begin with, complete or not at all. Throws OutputError.
  LineFile(std::string path, std::string_view beginning);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Throws OutputError.
  void append(const std::string& line) const;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace transformesh
