/// The loop of every evolution: iterations until its own rule says so or their limit is reached,
/// each recorded on disk (record.h), so that a run that was ended in any way continues to the same
/// bytes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/record.h"
#include "transformesh/control.h"
#include "transformesh/loop.h"

namespace transformesh {

/// What an evolution does in an iteration, and what it says of it.
class Loop {
 public:
  virtual ~Loop() = default;
  /// As messages call an iteration; its last word is the CSV column of the numbers.
  virtual std::string noun() const { return "iteration"; }
  /// Name of the first column of the CSV file, which holds the number of the iteration.
  virtual std::string column() const { return noun(); }
  /// Before the first iteration of a run that begins: by default the mesh is cleaned.
  virtual void start(Document& document, const Progress& progress);
  virtual void advance(Document& document, std::size_t iteration, const Progress& progress) = 0;
  /// Whether the rule of the loop ends it here.
  virtual bool is_done() const = 0;
  /// After the last iteration of this run: by default the mesh is cleaned once more.
  virtual void finish(Document& document, const Progress& progress);

  /// All that it needs to go on as if nothing had happened.
  virtual void remember(LoopState& loop_state) = 0;
  /// Of the last iteration: the further columns of the CSV file, and what follows its number in the
  /// line of progress. The columns are asked for before the first iteration as well.
  virtual void measure(CsvRow& row) const = 0;
  virtual std::string message() const = 0;
  /// Rows of the events of the last iteration (event_row.h).
  virtual std::vector<std::string> event_rows() const { return {}; }
};

/// Replaces the document by that of the state where the run continues. A failure of an iteration is
/// thrown again with its number in front, and the document is that of the last good iteration,
/// which is also that of the state; a failure before the first one is thrown as it is and leaves
/// no state. A loop that is done ends the record, which knows the number of iterations.
void run_loop(Loop& loop, Document& document, const LoopOptions& options, Record& record,
              const Progress& progress = Progress());

}  // namespace transformesh
