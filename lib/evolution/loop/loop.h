/// The loop of every evolution. It iterates until the evolution ends or the limit of iterations is
/// reached. Each iteration is recorded on disk (record.h), so that an interrupted run can be
/// continued and gives the same bytes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/record.h"
#include "transformesh/control.h"
#include "transformesh/loop.h"

namespace transformesh {

/// Interface of an evolution: the work of an iteration, its state, and its report.
class Loop {
 public:
  virtual ~Loop() = default;
  /// Returns the word for an iteration in messages.
  virtual std::string noun() const { return "iteration"; }
  /// Returns the name of the first CSV column, which holds the number of the iteration.
  virtual std::string column() const { return noun(); }
  /// Called before the first iteration of a run, but not if a run is continued. Cleans the mesh by
  /// default.
  virtual void start(Document& document, const Progress& progress);
  /// Makes an iteration; `iteration` counts from 1.
  virtual void advance(Document& document, std::size_t iteration, const Progress& progress) = 0;
  /// True if the evolution has ended.
  virtual bool is_done() const = 0;
  /// Called after the last iteration. Cleans the mesh by default.
  virtual void finish(Document& document, const Progress& progress);

  /// Names all variables that determine the further iterations. Stores or restores them, depending
  /// on how `loop_state` was constructed (loop_state.h).
  virtual void remember(LoopState& loop_state) = 0;
  /// Adds all CSV columns of the last iteration after the first column. Also called before the
  /// first iteration, for the header.
  virtual void measure(CsvRow& row) const = 0;
  /// Returns the text that follows the number of the last iteration in a message.
  virtual std::string message() const = 0;
  /// Returns the rows of the events of the last iteration (event_row.h).
  virtual std::vector<std::string> event_rows() const { return {}; }
};

/// Runs a loop. If a run is continued, the document is first replaced by that of the recorded
/// state. An exception in an iteration is rethrown with the number of the iteration; the document
/// and the recorded state are then those of the last successful iteration. If the first iteration
/// or a step before it fails, no state remains. Record::iteration() returns the number of
/// iterations.
void run_loop(Loop& loop, Document& document, const LoopOptions& options, Record& record,
              const Progress& progress = Progress());

}  // namespace transformesh
