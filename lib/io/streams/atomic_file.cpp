#include "io/streams/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "io/streams/output_target.h"
#include "io/streams/streams.h"

namespace transformesh {
namespace {

// An entry of a list of file names, which a signal handler may traverse at any time. An entry is
// complete before it is linked, and entries are never removed. The list stays short because a loop
// writes to the same few names.
struct TemporaryFile {
  const std::string path;
  TemporaryFile* const next;
  std::atomic<bool> exists{true};
};
std::atomic<TemporaryFile*> temporary_files{nullptr};

void note_temporary(const std::string& path, bool exists) {
  for (TemporaryFile* file = temporary_files; file != nullptr; file = file->next)
    if (file->path == path) return file->exists.store(exists);
  if (exists) temporary_files = new TemporaryFile{path, temporary_files};
}

void write_and_close(int descriptor, const std::string& path, std::string_view bytes) {
  const bool is_written = write_all(descriptor, bytes);
  const int write_error = errno;
  const bool is_closed = close(descriptor) == 0;
  if (!is_written) errno = write_error;
  if (!is_written || !is_closed) throw_not_written(path);
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::optional<mode_t> existing_mode(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return status.st_mode;
}

void write_directly(const std::string& path, std::string_view bytes) {
  // Stdout is closed, too, because some file systems report write errors only when a file is
  // closed.
  write_and_close(path == "-" ? STDOUT_FILENO : open_directly(path), path, bytes);
}

// Creates the temporary file. Its name is added to the list before the file exists.
int open_temporary(const std::string& target, std::string& name) {
  const std::string process = std::to_string(getpid());
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::string ending = ".";
    ending.append(process).append("-").append(std::to_string(attempt)).append(".tmp");
    name = name_beside(target, ".", ending);
    note_temporary(name, true);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return descriptor;
    note_temporary(name, false);
    if (errno != EEXIST) break;
  }
  name.clear();
  throw_not_written(target);
}

void remove_temporary(const std::string& path) {
  if (path.empty()) return;
  unlink(path.c_str());
  note_temporary(path, false);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path, std::string bytes)
    : target_(end_of_links(path)), is_direct_(is_written_directly(target_)) {
  is_direct_ ? bytes_.swap(bytes) : write_temporary(bytes);
}

AtomicFile::AtomicFile(const std::string& path)
    : target_(end_of_links(path)), is_direct_(is_written_directly(target_)) {
  if (is_direct_) return;
  descriptor_ = open_temporary(target_, temporary_);
  if (const auto mode = existing_mode(target_)) fchmod(descriptor_, *mode & 07777);
}

void AtomicFile::append(std::string_view bytes) {
  if (descriptor_ < 0) descriptor_ = target_ == "-" ? STDOUT_FILENO : open_directly(target_);
  if (!write_all(descriptor_, bytes)) throw_not_written(target_);
}

// Stdout is closed, too, because some file systems report write errors only when a file is closed.
void AtomicFile::finish() {
  is_finished_ = true;
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor >= 0 && close(descriptor) != 0) throw_not_written(target_);
}

void AtomicFile::write_temporary(std::string_view bytes) {
  const int descriptor = open_temporary(target_, temporary_);
  if (const auto mode = existing_mode(target_)) fchmod(descriptor, *mode & 07777);
  try {
    write_and_close(descriptor, target_, bytes);
  } catch (const OutputError&) {
    remove_temporary(std::exchange(temporary_, ""));
    throw;
  }
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      is_direct_(other.is_direct_),
      bytes_(std::move(other.bytes_)),
      temporary_(std::exchange(other.temporary_, "")),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_finished_(other.is_finished_) {}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) close(descriptor_);
  remove_temporary(temporary_);
}

void AtomicFile::commit() {
  if (descriptor_ >= 0) finish();
  if (is_direct_ && is_finished_) return;
  if (is_direct_) return write_directly(target_, std::exchange(bytes_, ""));
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) throw_not_written(target_);
  note_temporary(std::exchange(temporary_, ""), false);
}

void write_file(const std::string& path, std::string_view bytes) {
  const std::string target = end_of_links(path);
  is_written_directly(target) ? write_directly(target, bytes)
                              : AtomicFile(target, std::string(bytes)).commit();
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw OutputError("cannot make the folder '" + path + "': " + error.message());
}

void check_writable(const std::string& path) {
  if (path.empty()) throw OutputError("cannot write a file without a name");
  const std::string target = end_of_links(path);
  if (is_written_directly(target)) {
    if (S_ISDIR(existing_mode(target).value_or(0))) {
      errno = EISDIR;
      throw_not_written(path);
    }
    return;
  }
  struct stat status {};
  const bool is_named = lstat(target.c_str(), &status) == 0 || errno == ENOENT;
  if (!is_named || access(folder_of(target).c_str(), W_OK | X_OK) != 0) throw_not_written(path);
}

void remove_folder_at_signal(const std::string& path) { note_temporary(path, true); }

void remove_temporary_files() noexcept {
  for (const TemporaryFile* file = temporary_files; file != nullptr; file = file->next)
    if (file->exists && unlink(file->path.c_str()) != 0) rmdir(file->path.c_str());
}

}  // namespace transformesh
