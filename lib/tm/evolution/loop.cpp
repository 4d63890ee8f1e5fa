#include "tm/evolution/loop.h"

#include <utility>

#include "tm/support/error.h"

namespace transformesh {
namespace {

// Throws what is being handled again, of the same kind, with more in front.
[[noreturn]] void rethrow_in(const std::string& where) {
  try {
    throw;
  } catch (const UsageError& error) {
    throw UsageError(where + error.what());
  } catch (const InputError& error) {
    throw InputError(where + error.what());
  } catch (const GoalError& error) {
    throw GoalError(where + error.what());
  }
}

// The number of the iteration that was completed last.
std::size_t begin(Loop& loop, Document& document, Record& record, const Progress& progress) {
  if (record.resumed()) {
    document = record.resumed()->document;
    loop.restore(record.resumed()->values);
  } else {
    loop.start(document, progress);
  }
  record.begin(document, loop.csv_header(), loop.values());
  return record.resumed() ? record.resumed()->iteration : 0;
}

void advance(Loop& loop, Document& document, std::size_t iteration, const LoopOptions& options,
             Record& record, const Progress& progress) {
  Document next = document;
  try {
    loop.advance(next, iteration, progress);
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    if (iteration == 1) record.remove_state();
    rethrow_in(options.noun + ' ' + std::to_string(iteration) + ": ");
  }
  record.keep(next, iteration, loop.csv_row(iteration), loop.values());
  document = std::move(next);
  if (options.on_iteration) options.on_iteration(loop.message(iteration));
}

}  // namespace

LoopResult run_loop(Loop& loop, Document& document, const LoopOptions& options, Record& record,
                    const Progress& progress) {
  LoopResult result{begin(loop, document, record, progress), loop.is_done()};
  while (!result.is_done && result.iterations < options.iterations) {
    advance(loop, document, result.iterations + 1, options, record, progress);
    ++result.iterations;
    result.is_done = loop.is_done();
  }
  if (!result.is_done) record.pause(document, result.iterations, loop.values());
  return result;
}

}  // namespace transformesh
