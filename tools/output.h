/// Everything that a run writes, complete or not at all. A named file appears under its name only
/// when all outputs have been written; until then its bytes are in a temporary file beside it. What
/// is not a regular file (/dev/null, a FIFO) is written directly and never replaced.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace transformesh::tool {

struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws OutputError at once where writing this file cannot work: for before a long computation.
void check_writable(const std::string& path);

class Outputs {
 public:
  Outputs() = default;
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Writes the bytes to where they wait for commit(); `-` is stdout, which is written and closed
  /// now. Throws OutputError, and UsageError where a file of that place is staged already.
  void stage(const std::string& path, std::string_view bytes);
  /// Gives all staged files their names.
  void commit();

 private:
  struct Staged {
    std::string temporary;
    std::string target;
  };
  void stage_file(const std::string& target, std::string_view bytes);
  std::vector<Staged> staged_;
};

}  // namespace transformesh::tool
