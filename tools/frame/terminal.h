/// What the user sees on stderr, and what a signal leaves behind.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace transformesh::tool {

/// Before anything else: closed standard descriptors become unusable ones, so that no file takes
/// their number. SIGINT, SIGTERM, SIGPIPE, SIGXCPU and, unless nohup has it ignored, SIGHUP end the
/// process at once with 128 + their number, clear the terminal's line and remove temporary files.
/// SIGXFSZ is ignored: the write that grew too large fails and tells.
void prepare_streams_and_signals();

/// From now on SIGINT, SIGTERM and SIGHUP are told: `tm-x: interrupted by SIGINT` and the advice.
void tell_interruption(const std::string& program, const std::string& advice);

/// How progress is shown.
enum class ProgressStyle { none, bar, lines };

/// The one object that writes to stderr: messages, each one prefixed line, and progress. It knows
/// whether stderr is a terminal, may have color, and has a bar standing on its line.
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
  static void clear_bar();

  /// What progress() shows, for tests.
  void set_progress_style(ProgressStyle style) { progress_style_ = style; }

 private:
  std::string name_;
  bool is_quiet_ = false;
  bool is_verbose_ = false;
  ProgressStyle progress_style_ = ProgressStyle::none;
  Clock::time_point next_progress_;
};

}  // namespace transformesh::tool
