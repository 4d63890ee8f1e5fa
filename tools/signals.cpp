#include "signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "exit_code.h"

namespace transformesh::tool {
namespace {

struct TemporaryFile {
  std::atomic<bool> exists{false};
  std::array<char, 4096> path{};
};
// Enough for every image of a large data set; pages that are not used cost nothing.
std::array<TemporaryFile, 2048> temporary_files;
std::atomic<bool> bar_is_visible{false};

void write_text(int descriptor, std::string_view text) {
  // Nothing can be done about a failure while the process ends.
  [[maybe_unused]] const ssize_t written = write(descriptor, text.data(), text.size());
}

void end_process(int signal_number) {
  for (TemporaryFile& file : temporary_files) {
    if (file.exists) unlink(file.path.data());
  }
  if (bar_is_visible) write_text(STDERR_FILENO, "\r\033[K");
  _exit(exit_signal + signal_number);
}

TemporaryFile* find_file(const std::string& path) {
  for (TemporaryFile& file : temporary_files) {
    if (file.exists && path == file.path.data()) return &file;
  }
  return nullptr;
}

}  // namespace

void occupy_standard_descriptors() {
  // Reading from the first and writing to the others must go on failing.
  const std::array<int, 3> useless_mode = {O_WRONLY, O_RDONLY, O_RDONLY};
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) != -1) continue;
    open("/dev/null", useless_mode[static_cast<std::size_t>(descriptor)]);
  }
}

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = end_process;
  sigfillset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaction(number, &action, nullptr);
}

void remove_on_signal(const std::string& path) {
  for (TemporaryFile& file : temporary_files) {
    if (file.exists || path.size() >= file.path.size()) continue;
    std::memcpy(file.path.data(), path.c_str(), path.size() + 1);
    file.exists = true;
    return;
  }
  throw std::runtime_error("too many output files, or a path that is too long");
}

void keep_on_signal(const std::string& path) {
  if (TemporaryFile* file = find_file(path)) file->exists = false;
}

void set_bar_is_visible(bool is_visible) { bar_is_visible = is_visible; }

}  // namespace transformesh::tool
