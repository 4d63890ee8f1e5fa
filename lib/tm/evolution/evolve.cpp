#include "tm/evolution/evolve.h"

#include <utility>

#include "tm/evolution/loop/stop_rules.h"

namespace transformesh {
namespace {

class EvolveLoop : public Loop {
 public:
  EvolveLoop(const Step& step, IterationOptions options, const UntilRule& until)
      : step_(step), options_(std::move(options)), until_(until) {}

  void advance(Document& document, std::size_t /*iteration*/, const Progress& progress) override {
    options_.expects_changes = last_.was_cleaned;
    last_ = iterate(document, step_, options_, progress);
    is_done_ = until_.is_stalled
                   ? stalled_.add(last_.displaced.rms_displacement) || last_.displaced.moved == 0
                   : last_.displaced.max_displacement < until_.least_movement;
  }
  bool is_done() const override { return is_done_; }
  void remember(Memory& memory) override {
    stalled_.remember(memory);
    memory("done", is_done_);
  }

  void measure(CsvRow& row) const override {
    last_.measure_mesh(row);
    row.share("moved_fraction", last_.moved_share());
    row.number("max_displacement", last_.displaced.max_displacement);
    row.number("rms_displacement", last_.displaced.rms_displacement);
    last_.measure_times(row);
  }
  std::string message() const override {
    return ": " + in_words(last_.faces, last_.topology) + ", moved " +
           significant(last_.displaced.max_displacement, 3) + " at most";
  }

  const IterationResult& last() const { return last_; }

 private:
  const Step& step_;
  IterationOptions options_;
  UntilRule until_;
  StalledRule stalled_;
  IterationResult last_;
  bool is_done_ = false;
};

}  // namespace

EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop_options, Record& record, const Progress& progress) {
  EvolveLoop loop(step, completed(options.iteration, document.mesh), options.until);
  run_loop(loop, document, loop_options, record, progress);
  return {record.iteration(), loop.is_done(), loop.last()};
}

EvolveResult evolve(Mesh& mesh, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop, const Progress& progress) {
  Document document;
  document.mesh = std::move(mesh);
  Record record;
  try {
    const EvolveResult result = evolve(document, step, options, loop, record, progress);
    mesh = std::move(document.mesh);
    return result;
  } catch (...) {
    mesh = std::move(document.mesh);
    throw;
  }
}

}  // namespace transformesh
