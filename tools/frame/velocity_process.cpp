#include "frame/velocity_process.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include "frame/filter_process.h"
#include "frame/terminal.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

// Longest time to wait until the started command writes `ready`. Interpreters start in less time,
// even on a busy machine.
constexpr int most_milliseconds = 10'000;

}  // namespace

// Uses a socket instead of two pipes, so that writing to a command that has ended is an error and
// not a signal.
VelocityProcess::VelocityProcess(std::string command) : command_(std::move(command)) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw_not_run(command_);
  socket_ = ends[0];
  child_ = start_shell(command_, ends[1], ends[1]);
  set_child_group(child_);
  close(ends[1]);
  try {
    wait_until_ready();
  } catch (...) {
    end_child();
    throw;
  }
}

VelocityProcess::~VelocityProcess() { end_child(); }

void VelocityProcess::end_child() {
  close(socket_);
  for (int tries = 0; child_ != 0 && tries < 100; ++tries) {
    if (waitpid(child_, nullptr, WNOHANG) != 0) child_ = 0;
    if (child_ != 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (child_ != 0) kill(-child_, SIGTERM);
  set_child_group(0);
}

void VelocityProcess::wait_until_ready() {
  pollfd waiting{socket_, POLLIN, 0};
  if (poll(&waiting, 1, most_milliseconds) == 1 && line() == "ready") return;
  throw GoalError("'" + command_ +
                  "' did not begin with the line 'ready', which --persistent requires");
}

void VelocityProcess::throw_ended() {
  kill(-child_, SIGTERM);  // the command may have closed its output and still run
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = 0;
  check_ending(command_, status);
  throw GoalError("'" + command_ + "' ended before all velocities were computed");
}

void VelocityProcess::send(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_ended();
    sent += static_cast<std::size_t>(count);
  }
}

void VelocityProcess::receive(char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = recv(socket_, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw_ended();
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
}

std::string VelocityProcess::line() {
  constexpr std::size_t longest = 64;
  std::string text;
  char character = 0;
  for (receive(&character, 1); character != '\n' && text.size() < longest; receive(&character, 1))
    text += character;
  return text;
}

std::vector<Vec3> VelocityProcess::velocities(const std::string& ply, const Moment& moment) {
  send("mesh " + std::to_string(ply.size()) + ' ' + shortest_text(moment.time) + ' ' +
       shortest_text(moment.span) + ' ' + std::to_string(moment.stage) + '\n' + ply);
  constexpr std::string_view word = "velocities ";
  const std::string answer = line();
  const auto count =
      answer.starts_with(word) ? number_in<std::size_t>(answer.substr(word.size())) : std::nullopt;
  if (!count || *count > ply.size()) {
    throw InputError("'" + command_ + "' answered '" + answer +
                     "' instead of 'velocities' and the number of vertices");
  }
  std::vector<Vec3> velocities(*count);
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  receive(reinterpret_cast<char*>(velocities.data()), *count * sizeof(Vec3));
  return velocities;
}

}  // namespace transformesh::tool
