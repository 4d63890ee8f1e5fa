#include "io/streams/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "io/streams/streams.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// A choice. Half of the value would cause repeated reads; twice the value would be half of a small
/// machine's memory.
constexpr std::size_t most_resident_bytes = std::size_t{256} << 20;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw InputError(input_name(path) + ": cannot be read: " + reason);
}

/// Returns the bytes of file pages that are resident for this process.
std::size_t resident_file_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t total = 0, resident = 0, shared = 0;
  file >> total >> resident >> shared;
  return shared * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) fail(path, std::strerror(errno));
  struct stat status {};
  const bool is_regular = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  const auto size = static_cast<std::size_t>(status.st_size);
  void* data = nullptr;
  if (is_regular && size > 0) data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  const int error = errno;
  close(descriptor);
  if (!is_regular) fail(path, "a pipe or a folder cannot be read several times");
  if (size == 0) fail(path, "it is empty");
  if (data == MAP_FAILED) fail(path, std::strerror(error));
  bytes_ = {static_cast<const char*>(data), size};
}

MappedFile::~MappedFile() { munmap(const_cast<char*>(bytes_.data()), bytes_.size()); }

void MappedFile::release() const {
  if (resident_file_bytes() > most_resident_bytes)
    madvise(const_cast<char*>(bytes_.data()), bytes_.size(), MADV_DONTNEED);
}

}  // namespace transformesh
