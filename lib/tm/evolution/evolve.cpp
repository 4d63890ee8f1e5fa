#include "tm/evolution/evolve.h"

#include <utility>

#include "tm/evolution/csv_row.h"
#include "tm/evolution/stopwatch.h"
#include "tm/support/counted.h"

namespace transformesh {
namespace {

class EvolveLoop : public Loop {
 public:
  EvolveLoop(const Step& step, const EvolveOptions& options)
      : step_(step), options_(options), until_(options.until) {}

  void start(Document& document, const Progress& progress) override {
    clean_in_place(document, progress);
  }
  void advance(Document& document, std::size_t /*iteration*/, const Progress& progress) override {
    const Stopwatch watch;
    last_ = iterate(document, step_, options_.iteration, progress);
    seconds_ = watch.seconds();
    is_done_ = until_.add(last_.displaced);
  }
  bool is_done() const override { return is_done_; }

  Values values() const override {
    Values values = until_.values();
    values["done"] = is_done_ ? 1 : 0;
    return values;
  }
  void restore(const Values& values) override {
    until_.restore(values);
    const auto done = values.find("done");
    is_done_ = done != values.end() && done->second != 0;
  }

  std::string csv_header() const override {
    return "iteration,faces,pairs,components,genus,moved_fraction,max_displacement,"
           "rms_displacement,mean_edge,seconds_step,seconds_clean,seconds_remesh,seconds";
  }
  std::string csv_row(std::size_t iteration) const override;
  std::string message(std::size_t iteration) const override;
  const IterationResult& last() const { return last_; }

 private:
  double moved_share() const {
    return static_cast<double>(last_.displaced.moved) / static_cast<double>(last_.vertices);
  }

  const Step& step_;
  const EvolveOptions& options_;
  UntilRule until_;
  IterationResult last_;
  bool is_done_ = false;
  double seconds_ = 0;
};

std::string EvolveLoop::csv_row(std::size_t iteration) const {
  CsvRow row;
  row.count(iteration).count(last_.faces).count(last_.pairs);
  row.count(last_.topology.components).count(last_.topology.genus).share(moved_share());
  row.number(last_.displaced.max_displacement).number(last_.displaced.rms_displacement);
  row.number(last_.displaced.mean_edge).seconds(last_.seconds_step).seconds(last_.seconds_clean);
  return row.seconds(last_.seconds_remesh).seconds(seconds_).line();
}

std::string EvolveLoop::message(std::size_t iteration) const {
  return "iteration " + std::to_string(iteration) + ": " + counted(last_.faces, "face") + ", " +
         counted(last_.topology.components, "part") + ", genus " +
         std::to_string(last_.topology.genus) + ", moved " +
         significant(last_.displaced.max_displacement, 3) + " at most";
}

EvolveOptions completed(const EvolveOptions& options, const Mesh& mesh) {
  EvolveOptions result = options;
  double& reference_edge = result.iteration.reference_edge;
  if (reference_edge == 0) reference_edge = measured_reference_edge(mesh);
  return result;
}

}  // namespace

UntilRule moved_less_than(double length) {
  UntilRule rule;
  rule.kind_ = UntilRule::Kind::moved;
  rule.length_ = length;
  return rule;
}

UntilRule stalled() {
  UntilRule rule;
  rule.kind_ = UntilRule::Kind::stalled;
  return rule;
}

bool UntilRule::add(const DisplaceResult& displaced) {
  if (kind_ == Kind::moved) return displaced.max_displacement < length_;
  if (kind_ == Kind::never) return false;
  return stalled_.add(displaced.rms_displacement) || displaced.moved == 0;
}

Values UntilRule::values() const { return kind_ == Kind::stalled ? stalled_.values() : Values(); }

EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop_options, Record& record, const Progress& progress) {
  const EvolveOptions complete = completed(options, document.mesh);
  EvolveLoop loop(step, complete);
  const LoopResult result = run_loop(loop, document, loop_options, record, progress);
  clean_in_place(document, progress);
  if (result.is_done) record.end();
  return {result.iterations, result.is_done, loop.last()};
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
