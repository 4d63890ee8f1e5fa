#include "corpus/chains/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace chains {
namespace {

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe is left");
    read = ends[0], write = ends[1];
  }
  ~Pipe() { close_both(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_both() { close_end(read), close_end(write); }
  static void close_end(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

/// Between fork and exec, a process with several threads may only make async-signal-safe calls.
[[noreturn]] void become(const char* path, char* const* arguments, int in, int out, int messages,
                         const ProgramLimits& limits) {
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  signal(SIGPIPE, SIG_DFL);
  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  const rlimit cpu = {seconds, seconds + 1};
  const auto bytes = static_cast<rlim_t>(limits.gigabytes * 0x1p30);
  const rlimit space = {bytes, bytes}, core = {0, 0};
  setrlimit(RLIMIT_CPU, &cpu);
  setrlimit(RLIMIT_AS, &space);
  setrlimit(RLIMIT_CORE, &core);
  execv(path, arguments);
  _exit(127);
}

void take_some(int& end, std::string& bytes) {
  std::array<char, 65536> block;
  const ssize_t count = read(end, block.data(), block.size());
  if (count > 0)
    bytes.append(block.data(), static_cast<std::size_t>(count));
  else
    Pipe::close_end(end);
}

void give_some(int& end, const std::string& bytes, std::size_t& given) {
  const ssize_t count = write(end, bytes.data() + given, bytes.size() - given);
  if (count > 0) given += static_cast<std::size_t>(count);
  if (count <= 0 || given == bytes.size()) Pipe::close_end(end);
}

/// Copies bytes until the program has closed its pipes. Returns false after the limit of time.
bool feed(Pipe& in, Pipe& out, Pipe& messages, const std::string& input, ProgramResult& result,
          double seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto is_late = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >
           seconds;
  };
  fcntl(in.write, F_SETFL, O_NONBLOCK);
  std::size_t given = 0;
  while (out.read >= 0 || messages.read >= 0) {
    if (is_late()) return false;
    std::array<pollfd, 3> ends = {
        {{in.write, POLLOUT, 0}, {out.read, POLLIN, 0}, {messages.read, POLLIN, 0}}};
    poll(ends.data(), ends.size(), 1000);
    if (ends[0].revents != 0) give_some(in.write, input, given);
    if (ends[1].revents != 0) take_some(out.read, result.output);
    if (ends[2].revents != 0) take_some(messages.read, result.messages);
  }
  return true;
}

double cpu_seconds_of(const rusage& usage) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

ProgramResult run_program(const std::string& path, const std::vector<std::string>& arguments,
                          const std::string& input, const ProgramLimits& limits) {
  std::vector<std::string> words = {path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  Pipe in, out, messages;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process is left");
  if (child == 0) become(path.c_str(), pointers.data(), in.read, out.write, messages.write, limits);
  Pipe::close_end(in.read);
  Pipe::close_end(out.write);
  Pipe::close_end(messages.write);
  if (input.empty()) Pipe::close_end(in.write);

  ProgramResult result;
  const bool is_done = feed(in, out, messages, input, result, limits.wall_seconds);
  if (!is_done) kill(child, SIGKILL);
  Pipe::close_end(in.write);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  result.cpu_seconds = cpu_seconds_of(usage);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.exit_code = signal != 0 ? 128 + signal : WEXITSTATUS(status);
  // A program may also exit with the code by which a shell reports a signal.
  result.is_hung = !is_done || result.exit_code == 128 + SIGXCPU ||
                   (signal == SIGKILL && result.cpu_seconds >= limits.cpu_seconds);
  if (result.exit_code == 127) throw std::runtime_error("cannot run " + path);
  return result;
}

std::string in_one_line(std::string messages) {
  messages.erase(messages.find_last_not_of('\n') + 1);
  std::replace(messages.begin(), messages.end(), '\n', '/');
  return messages;
}

}  // namespace chains
