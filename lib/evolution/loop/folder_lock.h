/// Locks a folder for one process (flock). The system releases the lock when the process ends for
/// any reason, so that stale locks do not occur.
#pragma once

#include <string>

namespace transformesh {

class FolderLock {
 public:
  /// Creates the folder if it does not exist. Throws OutputError if another process holds the lock
  /// for a second or the folder cannot be created. On file systems without locks, nothing is locked
  /// and no error is thrown.
  explicit FolderLock(std::string folder);
  /// Removes the folder if it is empty. Also removes its parent folder if the constructor created
  /// it and it is empty. Both are also removed if a signal ends the process.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  bool lock();

  std::string folder_;
  /// Parent folder that the constructor created; empty if it existed before.
  std::string made_above_;
  int descriptor_ = -1;
};

}  // namespace transformesh
