/// The report of a run: its entries, the settings, counts of inputs and outputs, and timings.
#pragma once

#include <string>

#include "frame/inputs.h"

namespace transformesh::tool {

class RunReport {
 public:
  RunReport(const Program& program, Inputs& inputs, Messages& messages)
      : program_(program), inputs_(inputs), messages_(messages) {}

  void add(const std::string& key, const Value& value);
  void add(const Entries& entries) { append(result_, entries); }
  /// Prints the values of the program's own options if -v is given; later calls print nothing.
  void show_settings();
  /// Prints the entries if -v is given, unless they are the main output.
  void show_entries() const;
  /// True if the report of a program that writes a mesh is shown, because -v or --report is given.
  /// Otherwise programs may skip the computation of entries that only the report needs.
  bool is_shown() const { return messages_.are_detailed() || !program_.common.report.empty(); }

  /// Returns the report as the main output: lines, JSON with --json, or a single entry.
  std::string text() const;
  /// Returns the JSON of --report.
  std::string full(const Entries& output_counts, const Phases& phases);

 private:
  /// Throws UsageError if the report has no such key.
  std::string text_of_key(const std::string& only) const;

  const Program& program_;
  Inputs& inputs_;
  Messages& messages_;
  Entries result_;
  bool settings_are_shown_ = false;
};

}  // namespace transformesh::tool
