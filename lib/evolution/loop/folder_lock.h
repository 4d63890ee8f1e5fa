/// A folder that one process at a time uses. The system frees the lock of a process that has ended
/// in whatever way, so that none is ever left over.
#pragma once

#include <string>

namespace transformesh {

class FolderLock {
 public:
  /// Makes the folder where it is missing. Throws OutputError where another process keeps the lock
  /// for a second, or the folder cannot be made. A file system without locks gives none, and no
  /// error.
  explicit FolderLock(std::string folder);
  /// Removes the folder if there is nothing in it, and so the one above it where that was missing,
  /// as a signal that ends the process does.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  bool lock();

  std::string folder_;
  std::string made_above_;  ///< empty where the folder above was there
  int descriptor_ = -1;
};

}  // namespace transformesh
