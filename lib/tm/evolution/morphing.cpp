#include "tm/evolution/morphing.h"

#include <algorithm>
#include <cmath>

#include "tm/evolution/csv_row.h"
#include "tm/evolution/stop_rules.h"
#include "tm/evolution/stopwatch.h"
#include "tm/step/local_thickness.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

class MorphingLoop : public Loop {
 public:
  MorphingLoop(const Target& target, const MorphingOptions& options, const Progress& progress)
      : target_(target),
        options_(options),
        expected_(topology_of_target(target, progress)),
        rule_(options.scales) {}

  void start(Document& document, const Progress& progress) override {
    clean_in_place(document, progress);
  }
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return stop_ != MorphingStop::iteration_limit; }

  Values values() const override;
  void restore(const Values& values) override;
  std::string csv_header() const override;
  std::string csv_row(std::size_t iteration) const override;
  std::string message(std::size_t iteration) const override;

  const std::optional<Topology>& expected() const { return expected_; }
  MorphingStop stop() const { return stop_; }
  /// What was found when the iteration that ended the loop was looked at; it is not remembered.
  const std::optional<Agreement>& agreement() const { return agreement_; }

 private:
  void take_iteration(Document& document, const Progress& progress);
  MorphMeasures measures(std::size_t iteration) const;
  void follow(MorphVerdict verdict, const Document& document, const Progress& progress);

  const Target& target_;
  const MorphingOptions& options_;
  std::optional<Topology> expected_;
  MorphRule rule_;
  MorphingStop stop_ = MorphingStop::iteration_limit;
  MorphStepResult step_;
  IterationResult result_;
  int scale_ = 0;  ///< of the last iteration
  double seconds_ = 0;
  std::optional<Agreement> agreement_;
};

void MorphingLoop::take_iteration(Document& document, const Progress& progress) {
  scale_ = rule_.scale();
  IterationOptions iteration = options_.iteration;
  iteration.edge_factor = std::ldexp(1.0, scale_);
  const auto step = [&](Mesh& mesh, const Progress& step_progress) {
    step_ = morph_step(mesh, target_, options_.step, step_progress);
    return step_.displaced;
  };
  result_ = iterate(document, step, iteration, progress);
}

void MorphingLoop::advance(Document& document, std::size_t iteration, const Progress& progress) {
  const Stopwatch watch;
  agreement_.reset();
  const Document before = rule_.scale() > 0 ? document : Document();
  for (bool is_taken = false; !is_taken;) {
    try {
      take_iteration(document, progress);
      is_taken = true;
    } catch (const GoalError&) {
      if (rule_.scale() == 0) throw;
      rule_.skip_scale();
      document = before;
    }
  }
  seconds_ = watch.seconds();
  follow(rule_.add(measures(iteration)), document, progress);
}

MorphMeasures MorphingLoop::measures(std::size_t iteration) const {
  const DisplaceResult& moved = step_.displaced;
  return {iteration,
          result_.vertices,
          moved.clamped,
          moved.max_clamp_share,
          step_.to_target.rms,
          step_.to_target.maximum,
          step_.from_target.rms,
          step_.from_target.maximum,
          moved.mean_edge};
}

void MorphingLoop::follow(MorphVerdict verdict, const Document& document,
                          const Progress& progress) {
  const bool is_last = verdict == MorphVerdict::examine_last || verdict == MorphVerdict::stalled;
  if (is_last) stop_ = MorphingStop::stalled;
  if (verdict != MorphVerdict::examine && verdict != MorphVerdict::examine_last) return;
  agreement_ =
      transformesh::agreement(document.mesh, result_.topology, target_, expected_, progress);
  if (agreement_->fault.empty()) stop_ = MorphingStop::converged;
}

Values MorphingLoop::values() const {
  Values values = rule_.values();
  values["stop"] = static_cast<double>(stop_);
  return values;
}

void MorphingLoop::restore(const Values& values) {
  Values of_rule = values;
  const auto stop = of_rule.find("stop");
  if (stop == of_rule.end()) throw InputError("the state of the run is not that of a morph");
  stop_ = static_cast<MorphingStop>(stop->second);
  of_rule.erase(stop);
  rule_.restore(of_rule);
}

std::string MorphingLoop::csv_header() const {
  return "iteration,faces,pairs,components,genus,moved_fraction,max_clamp_share,"
         "rms_distance_to_target,max_distance_to_target,rms_distance_from_target,"
         "max_distance_from_target,mean_edge,seconds_step,seconds_clean,seconds_remesh,seconds,"
         "scale";
}

double moved_share(const IterationResult& result) {
  return static_cast<double>(result.displaced.moved) / static_cast<double>(result.vertices);
}

std::string MorphingLoop::csv_row(std::size_t iteration) const {
  CsvRow row;
  row.count(iteration).count(result_.faces).count(result_.pairs);
  row.count(result_.topology.components).count(result_.topology.genus);
  row.share(moved_share(result_)).share(step_.displaced.max_clamp_share);
  row.number(step_.to_target.rms).number(step_.to_target.maximum);
  row.number(step_.from_target.rms).number(step_.from_target.maximum);
  row.number(step_.displaced.mean_edge).seconds(result_.seconds_step);
  row.seconds(result_.seconds_clean).seconds(result_.seconds_remesh).seconds(seconds_);
  return row.count(scale_).line();
}

std::string MorphingLoop::message(std::size_t iteration) const {
  const double distance = std::max(step_.to_target.rms, step_.from_target.rms);
  return "iteration " + std::to_string(iteration) + ": " + counted(result_.faces, "face") + ", " +
         counted(result_.topology.components, "part") + ", genus " +
         std::to_string(result_.topology.genus) + ", moved " +
         std::to_string(static_cast<int>(100 * moved_share(result_))) + "%, distance " +
         significant(distance, 3);
}

MorphStepResult distances_of(Mesh mesh, const Target& target, const MorphStepOptions& options,
                             const Progress& progress) {
  MorphStepOptions at_rest;
  at_rest.distance = options.distance;
  at_rest.displace.alpha = 0;
  return morph_step(mesh, target, at_rest, progress);
}

// Cleaning the last mesh may undo what was found before, unless there was nothing to clean.
MorphingResult concluded(Document& document, const MorphingLoop& loop, const Target& target,
                         const MorphingOptions& options, const Progress& progress) {
  MorphingResult result;
  result.stop = loop.stop();
  result.expected = loop.expected();
  const CleanedTopology cleaned = clean_in_place(document, progress);
  result.topology = cleaned.topology;
  result.distances = distances_of(document.mesh, target, options.step, progress);
  const bool is_known =
      result.stop == MorphingStop::converged && !cleaned.changed && loop.agreement().has_value();
  result.agreement =
      is_known ? *loop.agreement()
               : agreement(document.mesh, result.topology, target, result.expected, progress);
  if (result.stop == MorphingStop::converged && !result.agreement.fault.empty())
    result.stop = MorphingStop::stalled;
  return result;
}

MorphingOptions completed(const MorphingOptions& options, const Document& document) {
  MorphingOptions result = options;
  double& reference_edge = result.iteration.reference_edge;
  if (reference_edge == 0) reference_edge = measured_reference_edge(document.mesh);
  result.step.largest_size = reference_edge;
  if (options.step.gap_edges > 0) result.iteration.remesh.size_column = "size";
  return result;
}

}  // namespace

const char* name_of(MorphingStop stop) {
  if (stop == MorphingStop::converged) return "converged";
  return stop == MorphingStop::stalled ? "stalled" : "iteration_limit";
}

void prepare_target(Target& target, const MorphingOptions& options, const Progress& progress) {
  if (options.step.gap_edges == 0 || !target.thickness.empty()) return;
  target.thickness =
      local_thickness(target, options.step.gap_edges * options.iteration.reference_edge, progress);
}

MorphingResult morph(Document& document, const Target& target, const MorphingOptions& options,
                     const LoopOptions& loop_options, Record& record, const Progress& progress) {
  const MorphingOptions complete = completed(options, document);
  MorphingLoop loop(target, complete, progress);
  const LoopResult loop_result = run_loop(loop, document, loop_options, record, progress);
  MorphingResult result = concluded(document, loop, target, complete, progress);
  result.iterations = loop_result.iterations;
  if (loop_result.is_done) record.end();
  return result;
}

}  // namespace transformesh
