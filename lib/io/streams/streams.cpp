#include "io/streams/streams.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <new>

#include "support/atomic_minimum.h"
#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

// Size of reads and of pipe buffers: 1 MB, the largest pipe buffer that Linux allows by default.
constexpr std::size_t read_size = std::size_t{1} << 20;

class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ > STDERR_FILENO) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void throw_unreadable(const std::string& path) {
  if (errno == EISDIR) throw InputError(input_name(path) + ": cannot be read: it is a folder");
  throw InputError(input_name(path) + ": cannot be read: " + std::strerror(errno));
}

// Returns true if the call can be repeated. Waits if the other process made the descriptor
// non-blocking.
bool may_retry(int descriptor, short events) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN) return false;
  pollfd waiting{descriptor, events, 0};
  poll(&waiting, 1, -1);
  return true;
}

// Enlarges the buffer of a pipe, for fewer context switches between the programs of a pipeline. If
// this fails, the buffer stays smaller.
void widen_pipe([[maybe_unused]] int descriptor) {
#ifdef F_SETPIPE_SZ
  fcntl(descriptor, F_SETPIPE_SZ, static_cast<int>(read_size));
#endif
}

// Returns the size of a regular file plus 1, so that one read reaches its end. Returns the size of
// a block for other files.
std::size_t first_read_size(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return read_size;
  return std::min(static_cast<std::size_t>(status.st_size) + 1, std::size_t{1} << 30);
}

// Reads the start of a regular file of this size in blocks, by several threads. Returns the number
// of bytes up to the first block that could not be read; reading continues there.
std::size_t read_blocks(int descriptor, std::size_t size, char* to) {
  std::atomic<std::size_t> complete = size;
  parallel_for((size + read_size - 1) / read_size, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t place = first * read_size; place < std::min(size, last * read_size);) {
      const std::size_t wanted = std::min(size, last * read_size) - place;
      const ssize_t got = pread(descriptor, to + place, wanted, static_cast<off_t>(place));
      if (got > 0) {
        place += static_cast<std::size_t>(got);
      } else if (got == 0 || errno != EINTR) {
        return lower_to(complete, place);
      }
    }
  });
  lseek(descriptor, static_cast<off_t>(complete.load()), SEEK_SET);
  return complete;
}

}  // namespace

char* Bytes::reserve(std::size_t size) {
  if (capacity_ - size_ < size) {
    const std::size_t capacity = std::max(size_ + size, 2 * capacity_);
    char* data = static_cast<char*>(std::realloc(data_.get(), capacity));
    if (data == nullptr) throw std::bad_alloc();
    static_cast<void>(data_.release());
    data_.reset(data);
    capacity_ = capacity;
  }
  return data_.get() + size_;
}

std::string input_name(const std::string& path) {
  if (path.empty()) return "''";
  return path == "-" ? "standard input" : path;
}

std::string input_folder(const std::string& path) {
  struct stat status {};
  if (path == "-" || stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

Bytes read_all(const std::string& path) {
  const Descriptor descriptor(path);
  if (descriptor.number() < 0) throw_unreadable(path);
  widen_pipe(descriptor.number());
  Bytes bytes;
  std::size_t wanted = first_read_size(descriptor.number());
  if (path != "-" && wanted > read_size) {
    const std::size_t size = wanted - 1;
    bytes.grow(read_blocks(descriptor.number(), size, bytes.reserve(wanted)));
    wanted -= bytes.view().size();
  }
  while (true) {
    char* end = bytes.reserve(wanted);
    const ssize_t got = read(descriptor.number(), end, wanted);
    if (got == 0) return bytes;
    if (got > 0) bytes.grow(static_cast<std::size_t>(got));
    if (got < 0 && !may_retry(descriptor.number(), POLLIN)) throw_unreadable(path);
    wanted = std::max(wanted - static_cast<std::size_t>(std::max<ssize_t>(got, 0)), read_size);
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  widen_pipe(descriptor);
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (!may_retry(descriptor, POLLOUT)) {
      return false;
    }
  }
  return true;
}

}  // namespace transformesh
