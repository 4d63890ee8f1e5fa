/// Files that appear under their names complete or not at all. The bytes are written to a temporary
/// file in the same folder, which is then renamed. A reader finds the old file or the new file,
/// even if the process is killed. A symbolic link is kept and its target replaced. A replaced file
/// keeps its permissions. Paths of other kinds (/dev/null, a FIFO, /dev/fd/3) are never replaced;
/// their bytes are written by commit(). `-` is stdout, which is then closed. Data is not
/// synchronized to the disk (fsync), so a crash of the machine may lose it.
#pragma once

#include <string>
#include <string_view>

#include "io/streams/output_target.h"
#include "transformesh/errors.h"

namespace transformesh {

class AtomicFile {
 public:
  /// Stores all bytes until commit(). Throws OutputError.
  AtomicFile(const std::string& path, std::string bytes);
  /// Opens an empty file, for outputs larger than memory. Stdout, devices and FIFOs have no
  /// temporary file: the first append() opens them directly. Throws OutputError.
  explicit AtomicFile(const std::string& path);
  /// Removes the temporary file unless it was committed.
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  /// append() adds bytes to a file that was opened empty, and finish() closes it. Both throw
  /// OutputError.
  void append(std::string_view bytes);
  void finish();

  /// Renames the temporary file. For stdout, devices and FIFOs, which have none, writes the stored
  /// bytes. Throws OutputError.
  void commit();
  bool is_direct() const { return is_direct_; }
  /// Returns the path of the final file, with symbolic links resolved.
  const std::string& target() const { return target_; }
  /// Returns a name that is the same for all paths to this file.
  std::string place() const { return place_of(target_); }

 private:
  void write_temporary(std::string_view bytes);

  std::string target_;
  bool is_direct_;
  std::string bytes_;      ///< bytes to be written directly by commit()
  std::string temporary_;  ///< name of the temporary file; empty if there is none
  int descriptor_ = -1;    ///< descriptor of the temporary file, open while bytes are appended
  bool is_finished_ = false;
};

/// Writes a whole file. Throws OutputError.
void write_file(const std::string& path, std::string_view bytes);

/// Creates a folder and its parents if they are missing. Throws OutputError.
void make_folder(const std::string& path);

/// Throws OutputError if the file certainly cannot be written. Call before a long computation.
void check_writable(const std::string& path);

/// Removes all temporary files that are not committed. For signal handlers that end the process:
/// async-signal-safe. Requires that only one thread writes files.
void remove_temporary_files() noexcept;
/// Adds an empty folder to the paths that remove_temporary_files() removes.
void remove_folder_at_signal(const std::string& path);

}  // namespace transformesh
