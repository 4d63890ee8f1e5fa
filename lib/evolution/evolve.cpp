#include "transformesh/evolve.h"

#include <algorithm>
#include <utility>

#include "evolution/end_rule.h"
#include "evolution/event_finder.h"
#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/mesh_document.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/recorded_loops.h"
#include "support/counted.h"
#include "support/number.h"
#include "support/percent.h"

namespace transformesh {
namespace {

class EvolveLoop : public Loop {
 public:
  EvolveLoop(const Step& step, IterationOptions options, const UntilRule& until, bool finds_events)
      : step_(step), options_(std::move(options)), end_rule_(until) {
    if (finds_events) events_.emplace().watch(options_);
  }

  void start(Document& document, const Progress& progress) override {
    clean_in_place(document, progress, options_.outermost);
    if (events_) events_->start(document.mesh);
  }
  void advance(Document& document, std::size_t iteration, const Progress& progress) override {
    options_.expects_changes = last_.was_cleaned;
    if (events_) events_->begin_step(document.mesh);
    last_ = iterate(document, step_, options_, progress);
    if (events_) events_->end_step(document.mesh, iteration, static_cast<double>(iteration));
    clamped_iterations_ += last_.displaced.clamped > 0 ? 1 : 0;
    clamped_share_ = std::max(clamped_share_, transformesh::clamped_share(last_));
    is_done_ = end_rule_.add(last_);
  }
  bool is_done() const override { return is_done_; }
  void finish(Document& document, const Progress& progress) override {
    clean_in_place(document, progress, options_.outermost);
  }
  void remember(LoopState& loop_state) override {
    end_rule_.remember(loop_state);
    if (events_) events_->remember(loop_state);
    loop_state("done", is_done_);
    loop_state("clamped_iterations", clamped_iterations_)("clamped_share", clamped_share_);
  }

  void measure(CsvRow& row) const override {
    measure_mesh(last_, row);
    row.share("moved_fraction", transformesh::moved_share(last_));
    row.number("max_displacement", last_.displaced.max_displacement);
    row.number("rms_displacement", last_.displaced.rms_displacement);
    measure_times(last_, row);
    row.share("clamped_fraction", transformesh::clamped_share(last_));
  }
  std::string message() const override {
    return ": " + in_words(last_.faces, last_.topology) + ", moved " +
           significant(last_.displaced.max_displacement, 3) + " at most";
  }

  std::vector<std::string> event_rows() const override {
    return events_ ? events_->last_rows() : std::vector<std::string>();
  }

  EvolveResult result(std::size_t iterations) const {
    EvolveResult result{iterations, is_done_, clamped_iterations_, clamped_share_, last_, {}, {}};
    if (events_) events_->report(result);
    return result;
  }

 private:
  const Step& step_;
  IterationOptions options_;
  EndRule end_rule_;
  std::optional<EventFinder> events_;
  IterationResult last_;
  bool is_done_ = false;
  std::size_t clamped_iterations_ = 0;
  double clamped_share_ = 0;
};

}  // namespace

std::string clamps_in_words(const EvolveResult& result, double alpha) {
  return "movements of up to " + percent_text(result.clamped_share) +
         " % of the vertices are clamped to " + shortest_text(alpha) + " of the mean edge in " +
         std::to_string(result.clamped_iterations) + " of " +
         counted(result.iterations, "iteration") +
         ": vertices moved less far than their velocities prescribe";
}

EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop_options, Record& record, const Progress& progress) {
  EvolveLoop loop(step, completed(options.iteration, document.mesh), options.until,
                  options.finds_events || record.has_events());
  run_loop(loop, document, loop_options, record, progress);
  return loop.result(record.iteration());
}

EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop, const Progress& progress) {
  Record record(loop.record);
  return evolve(document, step, options, loop, record, progress);
}

EvolveResult evolve(Mesh& mesh, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop, const Progress& progress) {
  return with_document(
      mesh, [&](Document& document) { return evolve(document, step, options, loop, progress); });
}

}  // namespace transformesh
