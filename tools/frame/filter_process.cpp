#include "frame/filter_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "frame/run.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(int descriptor, const char* mode, const std::string& command) {
  File file(descriptor < 0 ? nullptr : fdopen(descriptor, mode), std::fclose);
  if (!file) throw_not_run(command);
  return file;
}

// Puts the input into a file in memory. Therefore the input need not be written while the output is
// read, and a filter may end without reading all input.
File file_of(std::string_view input, const std::string& command) {
  File file = opened(memfd_create("input", MFD_CLOEXEC), "w+", command);
  const bool is_written = std::fwrite(input.data(), 1, input.size(), file.get()) == input.size();
  if (!is_written || std::fseek(file.get(), 0, SEEK_SET) != 0) throw_not_run(command);
  return file;
}

struct Output {
  File to_read, to_write;
};

Output output_of(FilterOutput kind, const std::string& command) {
  if (kind == FilterOutput::file) {
    File file = file_of("", command);
    return {opened(fcntl(fileno(file.get()), F_DUPFD_CLOEXEC, 0), "r", command), std::move(file)};
  }
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_not_run(command);
  return {opened(ends[0], "r", command), opened(ends[1], "w", command)};
}

std::string all_of(const File& file) {
  std::string output;
  std::array<char, 65536> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get()))
    output.append(block.data(), count);
  return output;
}

}  // namespace

void throw_not_run(const std::string& command) {
  throw GoalError("cannot run '" + command + "': " + std::strerror(errno));
}

pid_t start_shell(const std::string& command, int input, int output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  // The child gets its own process group, which set_child_group() ends together with this process.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const std::array<const char*, 5> words{"sh", "-c", "--", command.c_str(), nullptr};
  pid_t child = 0;
  // posix_spawn does not change `words`, although its parameter lacks const.
  // NOLINTNEXTLINE(*-const-cast,*-qualified-auto)
  auto* const arguments = const_cast<char* const*>(words.data());
  const int error = posix_spawn(&child, "/bin/sh", &actions, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  errno = error;
  if (error != 0) throw_not_run(command);
  return child;
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

std::string run_filter(const std::string& command, std::string_view input, FilterOutput output) {
  const File child_input = file_of(input, command);
  Output ends = output_of(output, command);
  const pid_t child = start_shell(command, fileno(child_input.get()), fileno(ends.to_write.get()));
  set_child_group(child);
  ends.to_write.reset();
  std::string bytes;
  if (output == FilterOutput::pipe) bytes = all_of(ends.to_read);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  set_child_group(0);
  check_ending(command, status);
  if (output == FilterOutput::pipe) return bytes;
  std::rewind(ends.to_read.get());
  return all_of(ends.to_read);
}

}  // namespace transformesh::tool
