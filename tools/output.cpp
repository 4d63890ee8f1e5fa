#include "output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "tm/io/streams.h"

namespace transformesh::tool {
namespace {

void write_standard_output(std::string_view bytes) {
  if (!write_all(STDOUT_FILENO, bytes) || close(STDOUT_FILENO) != 0)
    throw OutputError(std::string("cannot write standard output: ") + std::strerror(errno));
}

}  // namespace

void check_output(const std::string& path) {
  if (path != "-") check_writable(path);
}

void Outputs::stage(const std::string& path, std::string_view bytes) {
  if (path == "-") return write_standard_output(bytes);
  AtomicFile file(path, bytes);
  if (std::any_of(staged_.begin(), staged_.end(),
                  [&](const AtomicFile& other) { return other.has_target_of(file); }))
    throw UsageError("two outputs are called '" + file.target() + "': give each its own file");
  staged_.push_back(std::move(file));
}

void Outputs::commit() {
  for (AtomicFile& file : staged_) file.commit();
  staged_.clear();
}

}  // namespace transformesh::tool
