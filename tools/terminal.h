/// The one object that writes to stderr: messages, each one prefixed line, and progress. It knows
/// whether stderr is a terminal, may have color, and has a bar standing on its line.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace transformesh::tool {

/// How progress is shown.
enum class ProgressStyle { none, bar, lines };

class Terminal {
 public:
  explicit Terminal(std::string name) : name_(std::move(name)) {}
  ~Terminal() { clear_bar(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Follows -q, -v, --progress and --no-progress.
  void configure(bool quiet, bool verbose, bool progress, bool no_progress);

  void error(std::string_view message);
  void out_of_memory();                   ///< takes none
  void note(std::string_view message);    ///< unless -q
  void detail(std::string_view message);  ///< with -v
  bool is_verbose() const { return is_verbose_; }

  using Clock = std::chrono::steady_clock;
  /// Draws the bar or prints a line when the time for it has come.
  void progress(std::string_view phase, double fraction, Clock::time_point now = Clock::now());
  /// Text in the place of the bar, or a line of its own; nothing with -q.
  void progress_line(std::string_view text);
  /// To be called before anything else writes to the terminal.
  void clear_bar();

  /// What progress() shows, for tests.
  void set_progress_style(ProgressStyle style) { progress_style_ = style; }

 private:
  void print(std::string_view message);
  void draw_bar(std::string_view text);

  std::string name_;
  bool is_quiet_ = false;
  bool is_verbose_ = false;
  ProgressStyle progress_style_ = ProgressStyle::none;
  bool bar_stands_ = false;
  Clock::time_point started_ = Clock::now();
  Clock::time_point next_progress_ = started_;
};

/// Whether this descriptor is a terminal.
bool is_terminal(int descriptor);

}  // namespace transformesh::tool
