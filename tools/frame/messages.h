/// Messages of a run on stderr: notes, warnings with remedies, and details.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "frame/advice.h"
#include "frame/terminal.h"

namespace transformesh::tool {

class Messages {
 public:
  Messages(const Program& program, Terminal& terminal) : program_(program), terminal_(terminal) {}

  /// Prints a line, unless -q is given.
  void note(const std::string& message) const { terminal_.note(message); }
  void note(const Problem& warning) const { note(with_advice(warning, program_)); }
  /// Prints one line for each entry, unless -q is given.
  void note_all(const std::vector<std::string>& lines) const;
  void note_all(const std::vector<Problem>& warnings) const;
  /// Prints lines as note_all() does, but prints a line only once if it occurs several times in a
  /// run.
  void note_once(const std::vector<std::string>& lines);
  /// Prints a line if -v is given.
  void detail(const std::string& message) const { terminal_.detail(message); }
  /// Prints an error other than the error that ends the run.
  void error(const std::string& message) const { terminal_.error(message); }
  void out_of_memory() const { terminal_.out_of_memory(); }
  /// Shows a text in place of the progress bar, or prints it as a line with --progress.
  void progress_line(const std::string& text) const { terminal_.progress_line(text); }
  bool are_detailed() const { return terminal_.is_verbose(); }

 private:
  const Program& program_;
  Terminal& terminal_;
  std::set<std::string> noted_;
};

}  // namespace transformesh::tool
