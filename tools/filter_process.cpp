#include "filter_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "tm/support/error.h"
#include "tool.h"

namespace transformesh::tool {
namespace {

[[noreturn]] void throw_not_run(const std::string& command) {
  throw GoalError("cannot run '" + command + "': " + std::strerror(errno));
}

/// One end of a pipe, closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() {
    if (is_open()) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// The child's ends are closed here once it runs.
struct Pipes {
  Descriptor child_input, child_output, to_child, from_child;
};

std::array<int, 2> new_pipe(const std::string& command) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_not_run(command);
  return ends;
}

/// While alive, a child that does not read is an error of write() and no signal.
class BrokenPipeBlock {
 public:
  BrokenPipeBlock() {
    sigemptyset(&broken_pipe_);
    sigaddset(&broken_pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe_, &before_);
  }
  ~BrokenPipeBlock() {
    const timespec at_once{};
    while (sigtimedwait(&broken_pipe_, nullptr, &at_once) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  BrokenPipeBlock(const BrokenPipeBlock&) = delete;
  BrokenPipeBlock& operator=(const BrokenPipeBlock&) = delete;
  const sigset_t& before() const { return before_; }

 private:
  sigset_t broken_pipe_{};
  sigset_t before_{};
};

// The child gets an end of each pipe, and the signals as they were before.
pid_t start(const std::string& command, const Pipes& pipes, const sigset_t& signals) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipes.child_input.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipes.child_output.number(), STDOUT_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const std::array<const char*, 5> words{"sh", "-c", "--", command.c_str(), nullptr};
  pid_t child = 0;
  errno = posix_spawn(&child, "/bin/sh", &actions, &attributes,
                      const_cast<char* const*>(words.data()), environ);
  const int error = errno;
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  errno = error;
  return error == 0 ? child : -1;
}

// A filter may end without reading all of its input: what it wrote and its exit code decide.
void write_some(Descriptor& to, std::string_view& rest) {
  const ssize_t count = write(to.number(), rest.data(), rest.size());
  if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  const bool is_broken = count < 0 && errno != EINTR && errno != EAGAIN;
  if (rest.empty() || is_broken) to.close();
}

// Whether there is more to come.
bool read_some(const Descriptor& from, std::string& output) {
  std::array<char, 65536> block{};
  const ssize_t count = read(from.number(), block.data(), block.size());
  if (count > 0) output.append(block.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

// Both ways at once, as neither pipe holds all.
std::string exchange(Pipes& pipes, std::string_view input) {
  std::string output;
  fcntl(pipes.to_child.number(), F_SETFL, O_NONBLOCK);
  if (input.empty()) pipes.to_child.close();
  for (bool has_more = true; has_more;) {
    std::array<pollfd, 2> ends{pollfd{pipes.from_child.number(), POLLIN, 0},
                               pollfd{pipes.to_child.number(), POLLOUT, 0}};
    if (poll(ends.data(), pipes.to_child.is_open() ? 2 : 1, -1) < 0) continue;
    if (pipes.to_child.is_open() && ends[1].revents != 0) write_some(pipes.to_child, input);
    if (ends[0].revents != 0) has_more = read_some(pipes.from_child, output);
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
  const auto [child_input, to_child] = new_pipe(command);
  const auto [from_child, child_output] = new_pipe(command);
  Pipes pipes{Descriptor(child_input), Descriptor(child_output), Descriptor(to_child),
              Descriptor(from_child)};
  const BrokenPipeBlock block;
  const pid_t child = start(command, pipes, block.before());
  if (child < 0) throw_not_run(command);
  pipes.child_input.close();
  pipes.child_output.close();
  std::string output = exchange(pipes, input);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  check_ending(command, status);
  return output;
}

}  // namespace transformesh::tool
