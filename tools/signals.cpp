#include "signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string>
#include <string_view>

#include "exit_code.h"
#include "tm/io/atomic_file.h"

namespace transformesh::tool {
namespace {

// A list that the handler may walk at any time, until the very end: an entry is complete before it
// can be seen, and none is ever taken out.
struct TemporaryFile {
  const std::string path;
  TemporaryFile* const next;
  std::atomic<bool> exists{true};
};
std::atomic<TemporaryFile*> temporary_files{nullptr};
std::atomic<bool> bar_is_visible{false};

void write_text(int descriptor, std::string_view text) {
  // Nothing can be done about a failure while the process ends.
  [[maybe_unused]] const ssize_t written = write(descriptor, text.data(), text.size());
}

// Written once, before the handler may read it.
std::string interruption_start;
std::string interruption_end;
std::atomic<bool> interruption_is_told{false};

void tell(int signal_number) {
  const std::string_view name = signal_number == SIGINT    ? "SIGINT"
                                : signal_number == SIGTERM ? "SIGTERM"
                                : signal_number == SIGHUP  ? "SIGHUP"
                                                           : "";
  if (name.empty() || !interruption_is_told) return;
  for (const std::string_view part :
       {std::string_view(interruption_start), name, std::string_view(interruption_end)})
    write_text(STDERR_FILENO, part);
}

void end_process(int signal_number) {
  for (TemporaryFile* file = temporary_files; file != nullptr; file = file->next) {
    if (file->exists) unlink(file->path.c_str());
  }
  if (bar_is_visible) write_text(STDERR_FILENO, "\r\033[K");
  tell(signal_number);
  _exit(exit_signal + signal_number);
}

void remove_on_signal(const std::string& path) {
  // A loop writes the same few names again and again.
  for (TemporaryFile* file = temporary_files; file != nullptr; file = file->next) {
    if (file->path == path) return file->exists.store(true);
  }
  temporary_files = new TemporaryFile{path, temporary_files};
}

void keep_on_signal(const std::string& path) {
  for (TemporaryFile* file = temporary_files; file != nullptr; file = file->next) {
    if (file->exists && file->path == path) file->exists = false;
  }
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
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGXCPU}) sigaction(number, &action, nullptr);
  struct sigaction inherited {};
  sigaction(SIGHUP, nullptr, &inherited);
  if (inherited.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
  set_temporary_file_hook({remove_on_signal, keep_on_signal});
}

void tell_interruption(const std::string& program, const std::string& advice) {
  interruption_is_told = false;
  interruption_start = program + ": interrupted by ";
  interruption_end = advice + '\n';
  interruption_is_told = true;
}

void set_bar_is_visible(bool is_visible) { bar_is_visible = is_visible; }

}  // namespace transformesh::tool
