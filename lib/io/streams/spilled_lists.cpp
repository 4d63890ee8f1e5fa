#include "io/streams/spilled_lists.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

#include "io/streams/output_target.h"

namespace transformesh {
namespace {

/// Number of indices in a block of 64 KB. Smaller blocks need more system calls; larger blocks need
/// more memory for each list.
constexpr std::size_t indices_per_block = std::size_t{1} << 14;
constexpr std::size_t block_bytes = indices_per_block * sizeof(std::uint32_t);

}  // namespace

SpilledLists::SpilledLists(std::string folder, std::size_t count)
    : folder_(std::move(folder)), lists_(count) {
  std::string name = folder_ + "/.lists-XXXXXX";
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) throw_not_written(folder_);
  unlink(name.c_str());
}

SpilledLists::~SpilledLists() { close(descriptor_); }

void SpilledLists::add(std::size_t list, std::uint32_t index) {
  lists_[list].last.push_back(index);
  if (lists_[list].last.size() == indices_per_block) write(lists_[list]);
}

void SpilledLists::write(List& list) {
  const char* bytes = reinterpret_cast<const char*>(list.last.data());
  for (std::size_t done = 0; done < block_bytes;) {
    const ssize_t written =
        pwrite(descriptor_, bytes + done, block_bytes - done, static_cast<off_t>(size_ + done));
    if (written < 0 && errno != EINTR) throw_not_written(folder_);
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  list.offsets.push_back(size_);
  size_ += block_bytes;
  list.last.clear();
}

std::vector<std::uint32_t> SpilledLists::read(std::size_t list) const {
  const List& from = lists_[list];
  std::vector<std::uint32_t> result(from.offsets.size() * indices_per_block);
  char* to = reinterpret_cast<char*>(result.data());
  for (const std::uint64_t offset : from.offsets) {
    for (std::size_t done = 0; done < block_bytes;) {
      const ssize_t got =
          pread(descriptor_, to + done, block_bytes - done, static_cast<off_t>(offset + done));
      if (got == 0 || (got < 0 && errno != EINTR)) throw_not_written(folder_);
      if (got > 0) done += static_cast<std::size_t>(got);
    }
    to += block_bytes;
  }
  result.insert(result.end(), from.last.begin(), from.last.end());
  return result;
}

}  // namespace transformesh
