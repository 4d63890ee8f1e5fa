/// One run of a command-line program. The program's main function (its body) uses this object to
/// access inputs, outputs, report and messages.
#pragma once

#include <string>
#include <vector>

#include "frame/outputs.h"
#include "frame/run_report.h"
#include "transformesh/control.h"

namespace transformesh::tool {

class Run {
 public:
  Run(Program& program, Terminal& terminal);
  ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Returns the program, with the values of the command line.
  const Program& program() const { return program_; }
  Inputs& in() { return in_; }
  const Inputs& in() const { return in_; }
  Outputs& out() { return out_; }
  const Outputs& out() const { return out_; }
  const Messages& say() const { return messages_; }
  /// Returns the progress callback to pass to functions of the library. The callback also measures
  /// the times of phases for the report.
  const Progress& progress() const { return progress_; }

  /// Returns the first input mesh.
  Document& document() { return in_.document(); }
  /// Returns a length in input units (Inputs::length).
  double length(const Length& length) { return in_.length(length); }
  /// Prints a line on stderr, unless -q is given.
  void note(const std::string& message) const { messages_.note(message); }
  /// Adds entries to --report, and to stdout for programs that print a report, in the order of
  /// calls.
  void report(const std::string& key, const Value& value) { report_.add(key, value); }
  void report(const Entries& entries) { report_.add(entries); }
  bool shows_report() const { return report_.is_shown(); }
  /// Sets the answer of a program that answers a question. If the answer is no, the exit code is 1.
  void answer(bool is_yes) { answer_ = is_yes; }

  /// Programs that run an evolution call one of these two functions in their body. The function
  /// read_input() reads the input mesh. The function continue_from() takes the mesh of an
  /// interrupted run, which already has the comments of the output. For other programs, start()
  /// reads the input.
  Document& read_input();
  Document& continue_from(Document document);

  static std::string version();

  /// start() prepares the run before the program's body is called. finish() writes the outputs
  /// after it and returns the exit code.
  void start();
  int finish();

 private:
  Program& program_;
  Messages messages_;
  Phases phases_;
  Inputs in_;
  Outputs out_;
  RunReport report_;
  Progress progress_;
  bool answer_ = true;
};

}  // namespace transformesh::tool
