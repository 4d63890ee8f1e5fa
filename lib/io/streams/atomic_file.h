/// Files that appear under their names complete or not at all. The bytes are written to a temporary
/// file in the same folder, which is then renamed: a reader sees the old file or the new one, also
/// where the process is killed in between. A symbolic link stays and its target is replaced; the
/// permissions of a file replaced stay. What is not a regular file (/dev/null, a FIFO, /dev/fd/3)
/// is written directly when it is committed, and never replaced; `-` is stdout, which is closed.
/// Nothing is flushed to the disk itself, so a failure of the machine may lose what a failure of
/// the process does not.
#pragma once

#include <string>
#include <string_view>

#include "io/streams/output_target.h"
#include "transformesh/errors.h"

namespace transformesh {

class AtomicFile {
 public:
  /// Writes all bytes to where they wait for commit(). Throws OutputError.
  AtomicFile(const std::string& path, std::string bytes);
  /// Opens an empty file, for outputs larger than memory. One that is written directly is opened by
  /// the first append(). Throws OutputError.
  explicit AtomicFile(const std::string& path);
  /// Removes what was not committed.
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  /// Appends bytes to a file that was opened empty, and finish() closes it. Throw OutputError.
  void append(std::string_view bytes);
  void finish();

  /// Gives the file its name, or writes what is written directly. Throws OutputError.
  void commit();
  bool is_direct() const { return is_direct_; }
  /// Where the file will be: the end of the path's symbolic links.
  const std::string& target() const { return target_; }
  /// The same for all paths that lead to it.
  std::string place() const { return place_of(target_); }

 private:
  void write_temporary(std::string_view bytes);

  std::string target_;
  bool is_direct_;
  std::string bytes_;      ///< to be written directly
  std::string temporary_;  ///< empty once there is none
  int descriptor_ = -1;    ///< open while a file grows
  bool is_finished_ = false;
};

/// The whole file at once. Throws OutputError.
void write_file(const std::string& path, std::string_view bytes);

/// Where it is missing, with the folders above it. Throws OutputError.
void make_folder(const std::string& path);

/// Throws OutputError at once where writing this file cannot work: for before a long computation.
void check_writable(const std::string& path);

/// Removes all files that wait for their commit: for a handler of signals that ends the process,
/// and async-signal-safe. Files are written by one thread at a time.
void remove_temporary_files() noexcept;
/// From now on also this folder, where there is nothing in it.
void remove_folder_at_signal(const std::string& path);

}  // namespace transformesh
