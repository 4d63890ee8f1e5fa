/// The loop of every evolution. It makes iterations until the evolution ends or the limit of
/// iterations is reached. Each iteration is recorded on disk (record.h), so that an interrupted run
/// can be continued and gives the same bytes.
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
  /// Returns the word by which messages call an iteration, such as "frame".
  virtual std::string noun() const { return "iteration"; }
  /// Returns the name of the first CSV column, which holds the number of the iteration.
  virtual std::string column() const { return noun(); }
  /// Called before the first iteration of a new run, but not before a run is continued. By default,
  /// cleans the mesh.
  virtual void start(Document& document, const Progress& progress);
  /// Makes an iteration. The first iteration has number 1.
  virtual void advance(Document& document, std::size_t iteration, const Progress& progress) = 0;
  /// True if the evolution has ended.
  virtual bool is_done() const = 0;
  /// Called after the last iteration. By default, cleans the mesh.
  virtual void finish(Document& document, const Progress& progress);

  /// Passes to `loop_state`, by name, all variables on which further iterations depend. Depending
  /// on its constructor (loop_state.h), `loop_state` stores or restores these variables.
  virtual void remember(LoopState& loop_state) = 0;
  /// Adds the CSV columns of the last iteration, except the first column, which is its number. Also
  /// called before the first iteration, to get the header of the CSV file.
  virtual void measure(CsvRow& row) const = 0;
  /// Returns the text that follows the number of the last iteration in a message about progress.
  virtual std::string message() const = 0;
  /// Returns the CSV rows of the events that the last iteration found (event_row.h).
  virtual std::vector<std::string> event_rows() const { return {}; }
};

/// Runs a loop. If a run is continued, the document is first replaced by the document of the
/// recorded state. An exception in an iteration is rethrown with the number of the iteration. The
/// document and the recorded state are then those of the last successful iteration. If the first
/// iteration or a step before it fails, no state remains. Record::iteration() returns the number of
/// iterations.
void run_loop(Loop& loop, Document& document, const LoopOptions& options, Record& record,
              const Progress& progress = Progress());

}  // namespace transformesh
