#include "filter_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "frame/run.h"
#include "tm/support/error.h"

namespace transformesh::tool {
namespace {

[[noreturn]] void throw_not_run(const std::string& command) {
  throw GoalError("cannot run '" + command + "': " + std::strerror(errno));
}

/// A file, closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

// The whole input lies in a file in memory, so that nothing has to be written while the output is
// read, and a filter may end without reading all of it.
int file_of(std::string_view input, const std::string& command) {
  const int file = memfd_create("input", MFD_CLOEXEC);
  while (file >= 0 && !input.empty()) {
    const ssize_t count = write(file, input.data(), input.size());
    if (count < 0) break;
    input.remove_prefix(static_cast<std::size_t>(count));
  }
  if (!input.empty() || lseek(file, 0, SEEK_SET) != 0) throw_not_run(command);
  return file;
}

pid_t start(const std::string& command, const Descriptor& input, const Descriptor& output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.number(), STDOUT_FILENO);
  const std::array<const char*, 5> words{"sh", "-c", "--", command.c_str(), nullptr};
  pid_t child = 0;
  const int error = posix_spawn(&child, "/bin/sh", &actions, nullptr,
                                const_cast<char* const*>(words.data()), environ);
  posix_spawn_file_actions_destroy(&actions);
  errno = error;
  if (error != 0) throw_not_run(command);
  return child;
}

std::string all_of(const Descriptor& pipe) {
  std::string output;
  std::array<char, 65536> block{};
  for (ssize_t count = 1; count > 0 || (count < 0 && errno == EINTR);) {
    count = read(pipe.number(), block.data(), block.size());
    if (count > 0) output.append(block.data(), static_cast<std::size_t>(count));
  }
  return output;
}

void check_ending(const std::string& command, int status) {
  if (WIFSIGNALED(status)) {
    throw GoalError("'" + command + "' was ended by signal " + std::to_string(WTERMSIG(status)));
  }
  const int code = WEXITSTATUS(status);
  if (code == 0) return;
  const std::string message = "'" + command + "' ended with exit code " + std::to_string(code);
  if (code == exit_usage) throw UsageError(message);
  if (code == exit_input) throw InputError(message);
  throw GoalError(message);
}

}  // namespace

std::string run_filter(const std::string& command, std::string_view input) {
  const Descriptor child_input(file_of(input, command));
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_not_run(command);
  const Descriptor from_child(ends[0]);
  Descriptor child_output(ends[1]);
  const pid_t child = start(command, child_input, child_output);
  child_output.close();
  std::string output = all_of(from_child);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  check_ending(command, status);
  return output;
}

}  // namespace transformesh::tool
