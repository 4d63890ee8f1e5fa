#include "frame/terminal.h"

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <map>

#include "frame/program.h"
#include "io/streams/atomic_file.h"
#include "io/streams/streams.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

using namespace std::chrono_literals;

constexpr int bar_width = 30;
constexpr auto bar_delay = 500ms;  // delay of the progress bar, so that a quick run shows no bar
constexpr auto bar_interval = 100ms;
constexpr auto line_interval = 5s;
constexpr const char* erase_line = "\r\033[K";

using SignalMessages = std::map<int, std::string>;
// Messages for signal handlers. The table is complete before signal handlers can access it, and is
// never freed.
std::atomic<const SignalMessages*> messages{nullptr};
std::string time_message;
std::atomic<pid_t> child_group{0};
std::atomic<bool> bar_stands{false};

void write_once(std::string_view text) {
  // A failure is ignored, because the process ends.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

// Ends the process after a signal. This function and all functions that it calls are
// async-signal-safe.
void end_process(int signal_number) {
  std::string_view message;
  if (messages != nullptr) {
    const auto known = messages.load()->find(signal_number);
    if (known != messages.load()->end()) message = known->second;
  }
  end_process_with(message, signal_number == SIGALRM ? exit_goal : 128 + signal_number);
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// True for a terminal that understands escape sequences.
bool is_capable_terminal(int descriptor) {
  const std::string name = environment("TERM");
  return isatty(descriptor) == 1 && !name.empty() && name != "dumb";
}

void draw_bar(const std::string& text) {
  bar_stands = true;
  write_all(STDERR_FILENO, erase_line + text);
}

}  // namespace

void prepare_streams_and_signals() {
  // Opens closed standard descriptors, so that no other file gets their numbers. Stdin is opened
  // for writing, stdout and stderr for reading, so that their use still fails.
  const std::array<int, 3> useless_mode = {O_WRONLY, O_RDONLY, O_RDONLY};
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) != -1) continue;
    open("/dev/null", useless_mode[static_cast<std::size_t>(descriptor)]);
  }
  struct sigaction action {};
  action.sa_handler = end_process;
  sigfillset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGXCPU}) sigaction(number, &action, nullptr);
  struct sigaction inherited {};
  sigaction(SIGHUP, nullptr, &inherited);
  if (inherited.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

void end_process_with(std::string_view message, int exit_code) noexcept {
  remove_temporary_files();
  const pid_t group = child_group;
  if (group > 0) kill(-group, SIGTERM);
  if (bar_stands) write_once(erase_line);
  write_once(message);
  _exit(exit_code);
}

void set_child_group(pid_t group) { child_group = group; }

void limit_time(const std::string& program, double seconds) {
  time_message =
      program + ": stopped after " + shortest_text(seconds) + " s, the limit of --max-time";
  messages = new SignalMessages{{SIGALRM, time_message + "; nothing is written\n"}};
  struct sigaction action {};
  action.sa_handler = end_process;
  sigfillset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  sigset_t alarm;
  sigemptyset(&alarm);
  sigaddset(&alarm, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &alarm, nullptr);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  // A timer of 0 would mean no limit.
  timer.it_value.tv_usec =
      std::max<suseconds_t>(1, static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds))));
  if (setitimer(ITIMER_REAL, &timer, nullptr) != 0)
    throw UsageError("--max-time: this system cannot limit the time of a program");
}

void release_time() {
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
}

void report_interruption(const std::string& program, const std::string& advice) {
  const auto message = [&](const char* name) {
    return program + ": interrupted by " + name + advice + '\n';
  };
  messages = new SignalMessages{
      {SIGINT, message("SIGINT")},
      {SIGTERM, message("SIGTERM")},
      {SIGHUP, message("SIGHUP")},
      {SIGALRM, time_message + (advice.empty() ? "; nothing is written" : advice) + '\n'}};
}

void Terminal::configure(bool quiet, bool verbose, bool progress, bool no_progress) {
  is_quiet_ = quiet;
  is_verbose_ = verbose;
  if (no_progress || (quiet && !progress)) return;
  if (progress) progress_style_ = ProgressStyle::lines;
  if (is_capable_terminal(STDERR_FILENO)) progress_style_ = ProgressStyle::bar;
  next_progress_ =
      Clock::now() + (progress_style_ == ProgressStyle::bar ? bar_delay : line_interval);
}

void Terminal::error(std::string_view message) {
  clear_bar();
  const bool is_colored = is_capable_terminal(STDERR_FILENO) && environment("NO_COLOR").empty();
  std::string line = (is_colored ? "\033[1m" : "") + name_ + ":" + (is_colored ? "\033[0m " : " ");
  // A message is one line, even if file names or texts of libraries contain control characters.
  for (const char character : message) {
    const bool is_control = static_cast<unsigned char>(character) < ' ' || character == '\x7f';
    line += is_control ? ' ' : character;
  }
  write_all(STDERR_FILENO, line + '\n');
}

void Terminal::out_of_memory() {
  write_all(STDERR_FILENO, name_);
  write_all(STDERR_FILENO, ": ");
  write_all(STDERR_FILENO, out_of_memory_);
  write_all(STDERR_FILENO, "\n");
}

void Terminal::note(std::string_view message) {
  if (!is_quiet_) error(message);
}

void Terminal::detail(std::string_view message) {
  if (is_verbose_) error(message);
}

void Terminal::progress(std::string_view phase, double fraction, Clock::time_point now) {
  if (progress_style_ == ProgressStyle::none || now < next_progress_) return;
  const bool is_bar = progress_style_ == ProgressStyle::bar;
  next_progress_ = now + (is_bar ? bar_interval : line_interval);
  const auto percent = std::lround(100 * std::clamp(fraction, 0.0, 1.0));
  const std::string share = std::to_string(percent) + '%';
  if (!is_bar) return error(std::string(phase) + ' ' + share);
  const auto filled = static_cast<std::size_t>(percent * bar_width / 100);
  draw_bar(name_ + ": [" + std::string(filled, '#') + std::string(bar_width - filled, '-') + "] " +
           share + ' ' + std::string(phase));
}

void Terminal::progress_line(std::string_view text) {
  if (is_quiet_ || progress_style_ == ProgressStyle::none) return;
  if (progress_style_ == ProgressStyle::lines) return error(text);
  draw_bar(name_ + ": " + std::string(text));
}

void Terminal::clear_bar() {
  if (!bar_stands) return;
  write_all(STDERR_FILENO, erase_line);
  bar_stands = false;
}

}  // namespace transformesh::tool
