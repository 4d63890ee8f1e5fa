/// Output to stderr, and the handling of signals.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>

namespace transformesh::tool {

/// Must be called before all other functions. Replaces closed standard descriptors by unusable
/// ones, so that no file gets their number. SIGINT, SIGTERM, SIGPIPE and SIGXCPU end the process at
/// once with exit code 128 plus the number of the signal. Before, temporary files are removed and
/// the progress bar is erased. SIGHUP does the same unless nohup ignores it. SIGXFSZ is ignored, so
/// that a write beyond the file size limit fails and is reported.
void prepare_streams_and_signals();

/// Makes later SIGINT, SIGTERM and SIGHUP print `tm-x: interrupted by SIGINT` (or the other signal)
/// and the advice.
void report_interruption(const std::string& program, const std::string& advice);

/// Makes the process end after this time with exit code 4 and a message, in the same way as after a
/// signal. release_time() revokes the limit.
void limit_time(const std::string& program, double seconds);
void release_time();

/// Ends the process as a signal does, with a message. Allocates no memory.
[[noreturn]] void end_process_with(std::string_view message, int exit_code) noexcept;

/// Sets a process group that is ended together with this process; 0 for none.
void set_child_group(pid_t group);

/// Form in which progress is shown.
enum class ProgressStyle { none, bar, lines };

/// The only object that writes to stderr. A message is a line with the program's name. Tracks
/// whether stderr is a terminal, may have color, and shows a progress bar.
class Terminal {
 public:
  explicit Terminal(std::string name) : name_(std::move(name)) {}
  ~Terminal() { clear_bar(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Applies -q, -v, --progress and --no-progress.
  void configure(bool quiet, bool verbose, bool progress, bool no_progress);

  void error(std::string_view message);
  void out_of_memory();  ///< allocates no memory
  void set_out_of_memory(std::string reason) { out_of_memory_ = std::move(reason); }
  void note(std::string_view message);    ///< prints unless -q is given
  void detail(std::string_view message);  ///< prints if -v is given
  bool is_verbose() const { return is_verbose_; }

  using Clock = std::chrono::steady_clock;
  /// Draws the bar or prints a line of progress if enough time has passed since the last call that
  /// did so.
  void progress(std::string_view phase, double fraction, Clock::time_point now = Clock::now());
  /// Shows a text in place of the bar, or prints it as a line. Does nothing with -q.
  void progress_line(std::string_view text);
  /// Clears the progress bar. Must be called before other output is written to the terminal.
  static void clear_bar();

  /// Sets the form of progress(), for tests.
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
