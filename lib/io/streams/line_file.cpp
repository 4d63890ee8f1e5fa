#include "io/streams/line_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <utility>

#include "io/streams/atomic_file.h"
#include "io/streams/output_target.h"
#include "io/streams/streams.h"

namespace transformesh {

LineFile::LineFile(std::string path, std::string_view beginning) : path_(std::move(path)) {
  const std::string target = end_of_links(path_);
  if (is_written_directly(target)) {
    descriptor_ = open_directly(target);
    if (!write_all(descriptor_, beginning)) throw_not_written(path_);
  } else {
    write_file(target, beginning);
    descriptor_ = open(target.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (descriptor_ < 0) throw_not_written(path_);
  }
}

LineFile::~LineFile() { close(descriptor_); }

void LineFile::append(const std::string& line) const {
  if (!write_all(descriptor_, line + '\n')) throw_not_written(path_);
}

}  // namespace transformesh
