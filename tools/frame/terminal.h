/// What the user sees on stderr, and what a signal leaves behind.
#pragma once

#include <sys/types.h>

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
void report_interruption(const std::string& program, const std::string& advice);

/// The process ends with exit code 4 after so many seconds, as by a signal and with a message of
/// that kind, unless release_time() comes first.
void limit_time(const std::string& program, double seconds);
void release_time();

/// Ends the process as a signal does, with this message. Takes no memory.
[[noreturn]] void end_process_with(std::string_view message, int exit_code) noexcept;

/// A group of processes of ours, which ends with this one; 0: none.
void set_child_group(pid_t group);

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
  void out_of_memory();  ///< takes none
  void set_out_of_memory(std::string reason) { out_of_memory_ = std::move(reason); }
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
  std::string out_of_memory_ = "out of memory";
  bool is_quiet_ = false;
  bool is_verbose_ = false;
  ProgressStyle progress_style_ = ProgressStyle::none;
  Clock::time_point next_progress_;
};

}  // namespace transformesh::tool
