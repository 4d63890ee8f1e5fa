/// The loop of every evolution: iterations until its own rule says so or their limit is reached,
/// each recorded on disk (record.h), so that a run that was ended in any way continues to the same
/// bytes.
#pragma once

#include <functional>
#include <string>

#include "tm/evolution/record.h"
#include "tm/support/progress.h"

namespace transformesh {

/// What an evolution does in an iteration, and what it remembers from one to the next.
class Loop {
 public:
  virtual ~Loop() = default;
  /// Before the first iteration of a run that begins: makes the document ready.
  virtual void start(Document& document, const Progress& progress) = 0;
  virtual void advance(Document& document, std::size_t iteration, const Progress& progress) = 0;
  /// Whether the rule of the loop ends it here.
  virtual bool is_done() const = 0;

  /// What restore() needs to go on as if nothing had happened.
  virtual Values values() const = 0;
  virtual void restore(const Values& values) = 0;

  virtual std::string csv_header() const = 0;
  virtual std::string csv_row(std::size_t iteration) const = 0;
  /// One line of progress.
  virtual std::string message(std::size_t iteration) const = 0;
};

struct LoopOptions {
  std::size_t iterations = 1000;   ///< the limit, earlier runs included
  std::string noun = "iteration";  ///< as messages call one
  std::function<void(const std::string& message)> on_iteration = {};
};

struct LoopResult {
  std::size_t iterations = 0;  ///< earlier runs included
  bool is_done = false;        ///< by the rule, not by the limit
};

/// Replaces the document by that of the state where the run continues. A failure of an iteration is
/// thrown again with its number in front, and the document is that of the last good iteration,
/// which is also that of the state; a failure before the first one is thrown as it is and leaves
/// no state. Does not end the record where the loop is done: the caller does, with its result.
LoopResult run_loop(Loop& loop, Document& document, const LoopOptions& options, Record& record,
                    const Progress& progress = Progress());

}  // namespace transformesh
