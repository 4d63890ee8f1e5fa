#include "evolution/loop/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "io/streams/atomic_file.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

// True if the opened folder still has the path `folder`. Another process may have removed it.
bool is_still_named(int descriptor, const std::string& folder) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(folder.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

// True if another process keeps the lock for a second. The short wait is needed: a process that is
// killed during fork() leaves its lock to the child until the child calls exec().
bool is_locked_by_another(int descriptor) {
  for (int tries = 0; tries < 50; ++tries) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

}  // namespace

FolderLock::FolderLock(std::string folder) : folder_(std::move(folder)) {
  const std::filesystem::path above = std::filesystem::path(folder_).parent_path();
  std::error_code ignored;
  if (!above.empty() && !std::filesystem::exists(above, ignored)) made_above_ = above;
  if (!made_above_.empty()) remove_folder_at_signal(made_above_);
  remove_folder_at_signal(folder_);
  while (!lock()) {
  }
}

bool FolderLock::lock() {
  make_folder(folder_);
  descriptor_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) return errno != ENOENT;
  if (is_locked_by_another(descriptor_)) {
    close(descriptor_);
    throw OutputError("another run is writing the same output, with its state in '" + folder_ +
                      "': wait until that run ends, or name another output");
  }
  if (is_still_named(descriptor_, folder_)) return true;
  close(descriptor_);
  return false;
}

FolderLock::~FolderLock() {
  if (rmdir(folder_.c_str()) == 0 && !made_above_.empty()) rmdir(made_above_.c_str());
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace transformesh
