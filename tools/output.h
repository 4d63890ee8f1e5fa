/// Everything that a run writes, complete or not at all. A named file appears under its name only
/// when all outputs have been written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tm/io/atomic_file.h"

namespace transformesh::tool {

/// Throws OutputError at once where writing there cannot work; `-` is stdout.
void check_output(const std::string& path);

class Outputs {
 public:
  /// Writes the bytes to where they wait for commit(); `-` is stdout, which is written and closed
  /// now. Throws OutputError, and UsageError where a file of that place is staged already.
  void stage(const std::string& path, std::string_view bytes);
  /// Gives all staged files their names.
  void commit();

 private:
  std::vector<AtomicFile> staged_;
};

}  // namespace transformesh::tool
