#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "signals.h"
#include "tm/io/streams.h"

namespace transformesh::tool {
namespace {

using namespace std::chrono_literals;

constexpr int bar_width = 30;
constexpr auto bar_delay = 500ms;  // a quick run shows no bar
constexpr auto bar_interval = 100ms;
constexpr auto line_interval = 5s;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// A terminal that understands escape sequences.
bool is_capable_terminal(int descriptor) {
  const std::string name = environment("TERM");
  return is_terminal(descriptor) && !name.empty() && name != "dumb";
}

bool has_color() { return is_capable_terminal(STDERR_FILENO) && environment("NO_COLOR").empty(); }

void print_raw(const std::string& text) { write_all(STDERR_FILENO, text); }

int percent(double fraction) {
  return static_cast<int>(std::lround(100 * std::clamp(fraction, 0.0, 1.0)));
}

}  // namespace

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

void Terminal::configure(bool quiet, bool verbose, bool progress, bool no_progress) {
  is_quiet_ = quiet;
  is_verbose_ = verbose;
  if (no_progress || (quiet && !progress)) {
    progress_style_ = ProgressStyle::none;
  } else if (is_capable_terminal(STDERR_FILENO)) {
    progress_style_ = ProgressStyle::bar;
  } else if (progress) {
    progress_style_ = ProgressStyle::lines;
  }
  next_progress_ = started_ + (progress_style_ == ProgressStyle::bar ? bar_delay : line_interval);
}

void Terminal::error(std::string_view message) { print(message); }

void Terminal::out_of_memory() {
  write_all(STDERR_FILENO, name_);
  write_all(STDERR_FILENO, ": out of memory\n");
}

void Terminal::note(std::string_view message) {
  if (!is_quiet_) print(message);
}

void Terminal::detail(std::string_view message) {
  if (is_verbose_) print(message);
}

void Terminal::print(std::string_view message) {
  clear_bar();
  const bool is_colored = has_color();
  std::string line = (is_colored ? "\033[1m" : "") + name_ + ":" + (is_colored ? "\033[0m " : " ");
  // One message is one line, whatever file names or library texts it holds.
  for (const char character : message) {
    const bool is_control = static_cast<unsigned char>(character) < ' ' || character == '\x7f';
    line += is_control ? ' ' : character;
  }
  print_raw(line + '\n');
}

void Terminal::progress(std::string_view phase, double fraction, Clock::time_point now) {
  if (progress_style_ == ProgressStyle::none || now < next_progress_) return;
  if (progress_style_ == ProgressStyle::bar) {
    next_progress_ = now + bar_interval;
    const auto filled = static_cast<std::size_t>(percent(fraction) * bar_width / 100);
    draw_bar('[' + std::string(filled, '#') + std::string(bar_width - filled, '-') + "] " +
             std::to_string(percent(fraction)) + "% " + std::string(phase));
  } else {
    next_progress_ = now + line_interval;
    print(std::string(phase) + ' ' + std::to_string(percent(fraction)) + '%');
  }
}

void Terminal::progress_line(std::string_view text) {
  if (is_quiet_ || progress_style_ == ProgressStyle::none) return;
  if (progress_style_ == ProgressStyle::bar) return draw_bar(text);
  print(text);
}

void Terminal::draw_bar(std::string_view text) {
  set_bar_is_visible(true);
  bar_stands_ = true;
  print_raw("\r\033[K" + name_ + ": " + std::string(text));
}

void Terminal::clear_bar() {
  if (!bar_stands_) return;
  print_raw("\r\033[K");
  bar_stands_ = false;
  set_bar_is_visible(false);
}

}  // namespace transformesh::tool
