#include "signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <map>
#include <string_view>

#include "tm/io/atomic_file.h"

namespace transformesh::tool {
namespace {

using Messages = std::map<int, std::string>;
// Complete before it can be seen, and never freed.
std::atomic<const Messages*> messages{nullptr};
std::atomic<bool> bar_is_visible{false};

void write_error(std::string_view text) {
  // Nothing can be done about a failure while the process ends.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

void end_process(int signal_number) {
  remove_temporary_files();
  if (bar_is_visible) write_error("\r\033[K");
  if (messages != nullptr) {
    const auto message = messages.load()->find(signal_number);
    if (message != messages.load()->end()) write_error(message->second);
  }
  _exit(128 + signal_number);
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
}

void tell_interruption(const std::string& program, const std::string& advice) {
  const auto message = [&](const char* name) {
    return program + ": interrupted by " + name + advice + '\n';
  };
  messages = new Messages{
      {SIGINT, message("SIGINT")}, {SIGTERM, message("SIGTERM")}, {SIGHUP, message("SIGHUP")}};
}

void set_bar_is_visible(bool is_visible) { bar_is_visible = is_visible; }

}  // namespace transformesh::tool
