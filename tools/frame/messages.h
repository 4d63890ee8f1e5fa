/// Messages of a run on stderr: notes, warnings with the remedies that the program offers, details.
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

  /// One line, unless -q.
  void note(const std::string& message) const { terminal_.note(message); }
  void note(const Problem& warning) const { note(with_advice(warning, program_)); }
  /// One line each.
  void note_all(const std::vector<std::string>& lines) const;
  void note_all(const std::vector<Problem>& warnings) const;
  /// One line each, and each line once in a run.
  void note_once(const std::vector<std::string>& lines);
  /// One line with -v.
  void detail(const std::string& message) const { terminal_.detail(message); }
  /// Always, for a failure beside the one that ends the run.
  void error(const std::string& message) const { terminal_.error(message); }
  void out_of_memory() const { terminal_.out_of_memory(); }
  /// A line in the place of the progress bar, or a line of its own with --progress.
  void progress_line(const std::string& text) const { terminal_.progress_line(text); }
  bool are_detailed() const { return terminal_.is_verbose(); }

 private:
  const Program& program_;
  Terminal& terminal_;
  std::set<std::string> noted_;
};

}  // namespace transformesh::tool
