/// A file that grows by lines, each written by one call. A FIFO, /dev/stderr or /dev/fd/63 stays
/// open from the first line to the last, so that its reader gets one stream.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

class LineFile {
 public:
  /// Creates the file with the lines in `beginning`, complete or not at all. Throws OutputError.
  LineFile(std::string path, std::string_view beginning);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Appends a line. Throws OutputError.
  void append(const std::string& line) const;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace transformesh
