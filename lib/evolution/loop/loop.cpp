#include "evolution/loop/loop.h"

#include <utility>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "transformesh/iteration.h"

namespace transformesh {
namespace {

LoopState loop_state_of(Loop& loop) {
  LoopState loop_state;
  loop.remember(loop_state);
  return loop_state;
}

CsvRow row_of(const Loop& loop, std::size_t iteration) {
  CsvRow row;
  row.count(loop.column(), iteration);
  loop.measure(row);
  return row;
}

void begin(Loop& loop, Document& document, Record& record, const Progress& progress) {
  if (record.resumed()) {
    document = record.resumed()->document;
    LoopState loop_state = record.resumed()->loop_state;
    loop.remember(loop_state);
  } else {
    loop.start(document, progress);
  }
  record.begin(document, row_of(loop, 0).header(), loop_state_of(loop));
}

void advance(Loop& loop, Document& document, const LoopOptions& options, Record& record,
             const Progress& progress) {
  const std::size_t iteration = record.iteration() + 1;
  const std::string name = loop.noun() + ' ' + std::to_string(iteration);
  Document next = document;
  try {
    loop.advance(next, iteration, progress);
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    if (iteration == 1) record.remove_state();
    rethrow_with_prefix(name + ": ");
  }
  record.keep(next, iteration, row_of(loop, iteration).line(), loop_state_of(loop),
              loop.event_rows());
  document = std::move(next);
  if (options.on_iteration) options.on_iteration(name + loop.message());
}

}  // namespace

void Loop::start(Document& document, const Progress& progress) {
  clean_in_place(document, progress);
}

void Loop::finish(Document& document, const Progress& progress) {
  clean_in_place(document, progress);
}

void run_loop(Loop& loop, Document& document, const LoopOptions& options, Record& record,
              const Progress& progress) {
  begin(loop, document, record, progress);
  while (!loop.is_done() && record.iteration() < options.iterations)
    advance(loop, document, options, record, progress);
  const bool is_done = loop.is_done();
  if (!is_done) record.pause(document, loop_state_of(loop));
  loop.finish(document, progress);
  if (is_done) record.end();
}

}  // namespace transformesh
