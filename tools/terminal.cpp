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
    draw_bar(phase, fraction);
  } else {
    next_progress_ = now + line_interval;
    print(std::string(phase) + ' ' + std::to_string(percent(fraction)) + '%');
  }
}

void Terminal::draw_bar(std::string_view phase, double fraction) {
  constexpr int width = 30;
  const int filled = percent(fraction) * width / 100;
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(width - filled), '-');
  const std::string name(phase);
  set_bar_is_visible(true);
  bar_stands_ = true;
  print_raw("\r\033[K" + name_ + ": [" + bar + "] " + std::to_string(percent(fraction)) + "% " +
            name);
}

void Terminal::clear_bar() {
  if (!bar_stands_) return;
  print_raw("\r\033[K");
  bar_stands_ = false;
  set_bar_is_visible(false);
}

}  // namespace transformesh::tool
