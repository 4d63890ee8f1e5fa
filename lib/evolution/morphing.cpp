#include "evolution/morphing.h"

#include <algorithm>
#include <cmath>

#include "evolution/loop/stop_rules.h"
#include "evolution/loop/stopwatch.h"
#include "io/mesh_io.h"
#include "mesh/measure.h"
#include "remesh/align_features.h"
#include "step/local_thickness.h"
#include "support/empty_result_error.h"

namespace transformesh {
namespace {

std::optional<Target> measured(const Target& target, const MorphingOptions& options,
                               const Progress& progress) {
  if (options.step.gap_edges == 0 || !target.thickness.empty()) return std::nullopt;
  return with_thickness(target, options.step.gap_edges, options.iteration.reference_edge, progress);
}

class MorphingLoop : public Loop {
 public:
  MorphingLoop(const Target& target, const MorphingOptions& options, const Progress& progress)
      : target_(target),
        measured_(measured(target, options, progress)),
        query_(measured_ ? *measured_ : target),
        options_(options),
        rule_(options.scales),
        goal_(goal_of(target, progress)) {
    result_.expected = goal_.topology;
    result_.left_out = goal_.left_out;
  }

  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return result_.stop != MorphingStop::iteration_limit; }
  void finish(Document& document, const Progress& progress) override;

  void remember(LoopState& loop_state) override {
    rule_.remember(loop_state);
    loop_state("stop", result_.stop);
  }
  void measure(CsvRow& row) const override;
  std::string message() const override;

  const MorphingResult& result() const { return result_; }
  /// The remedy for a surface that vanished; empty if it did not.
  const std::optional<MorphRemedy>& remedy() const { return remedy_; }

 private:
  bool takes_iteration(Document& document, bool remeshes_first, const Progress& progress);
  void take_iteration(Document& document, const Progress& progress);
  void align(Document& document, const Progress& progress);
  void conclude(Document& document, const Progress& progress);
  Agreement agreement_of(const Document& document, const Topology& topology,
                         const Progress& progress) const {
    return agreement(document.mesh, topology, query_, goal_, progress);
  }
  MorphStepOptions step_options() const {
    MorphStepOptions options = options_.step;
    if (goal_.without_those) options.goal = &*goal_.without_those;
    return options;
  }
  [[noreturn]] void vanish(const Mesh& mesh);

  const Target& target_;
  const std::optional<Target> measured_;  ///< with its thickness, if that is needed and missing
  const TargetQuery query_;
  const MorphingOptions& options_;
  MorphRule rule_;
  const MorphGoal goal_;
  MorphingResult result_;
  std::optional<MorphRemedy> remedy_;

  // The last iteration.
  int scale_ = 0;
  MorphStepResult step_;
  IterationResult last_;
  std::optional<Agreement> agreement_;  ///< if it was looked at
};

// False where that fails, and something else is to be tried. With the edges of the scale first, the
// step is shorter.
bool MorphingLoop::takes_iteration(Document& document, bool remeshes_first,
                                   const Progress& progress) {
  scale_ = rule_.scale();
  IterationOptions iteration = options_.iteration;
  iteration.edge_factor = std::ldexp(1.0, scale_);
  iteration.expects_changes = last_.was_cleaned;
  const auto step = [&](Mesh& mesh, const Progress& step_progress) {
    step_ = morph_step(mesh, query_, step_options(), step_progress);
    return step_.displaced;
  };
  const bool is_last = options_.scales == 1 || (scale_ == 0 && remeshes_first);
  try {
    if (remeshes_first) remesh_in_place(document, iteration, progress);
    last_ = iterate(document, step, iteration, progress);
    return true;
  } catch (const EmptyResultError&) {
    if (is_last) vanish(document.mesh);
    return false;
  } catch (const GoalError&) {
    if (is_last) throw;
    return false;
  }
}

void MorphingLoop::vanish(const Mesh& mesh) {
  remedy_ = remedy_for_vanished(target_, edge_lengths(mesh).maximum);
  const std::string reason = reason_of(*remedy_);
  throw EmptyResultError("the surface shrinks to nothing" + (reason.empty() ? "" : ": " + reason));
}

// A coarse scale may have no edges for what is left, or steps so long that they turn it inside out.
void MorphingLoop::take_iteration(Document& document, const Progress& progress) {
  const Document before = options_.scales > 1 ? document : Document();
  bool is_first_try = true;
  bool remeshes_first = false;
  while (!takes_iteration(document, remeshes_first, progress)) {
    document = before;
    remeshes_first = !remeshes_first && (!is_first_try || scale_ == 0);
    if (!remeshes_first) rule_.skip_scale();
    is_first_try = false;
  }
}

void MorphingLoop::advance(Document& document, std::size_t /*iteration*/,
                           const Progress& progress) {
  const Stopwatch watch;
  take_iteration(document, progress);
  last_.seconds = watch.seconds();

  const MorphVerdict verdict = rule_.add(step_, last_.vertices);
  const bool is_last = verdict == MorphVerdict::examine_last || verdict == MorphVerdict::stalled;
  if (is_last) result_.stop = MorphingStop::stalled;
  agreement_.reset();
  if (verdict != MorphVerdict::examine && verdict != MorphVerdict::examine_last) return;
  agreement_ = agreement_of(document, last_.topology, progress);
  if (agreement_->fault.empty()) result_.stop = MorphingStop::converged;
}

void MorphingLoop::measure(CsvRow& row) const {
  last_.measure_mesh(row);
  row.share("moved_fraction", last_.moved_share());
  row.share("max_clamp_share", step_.displaced.max_clamp_share);
  row.number("rms_distance_to_target", step_.to_target.rms);
  row.number("max_distance_to_target", step_.to_target.maximum);
  row.number("rms_distance_from_target", step_.from_target.rms);
  row.number("max_distance_from_target", step_.from_target.maximum);
  last_.measure_times(row);
  row.count("scale", scale_).share("clamped_fraction", last_.clamped_share());
}

std::string MorphingLoop::message() const {
  return ": " + in_words(last_.faces, last_.topology) + ", moved " +
         std::to_string(static_cast<int>(100 * last_.moved_share())) + "%, distance " +
         significant(std::max(step_.to_target.rms, step_.from_target.rms), 3);
}

// Nothing moves towards the target any more, and smoothing rounds nothing off again.
void MorphingLoop::align(Document& document, const Progress& progress) {
  const bool may_align = target_.is_mesh() && options_.features != Features::off;
  if (!may_align || (options_.features == Features::automatic && !has_features(target_.mesh)))
    return;
  const EdgeLengths edges = edge_lengths(document.mesh);
  AlignOptions options;
  options.limits = {edges.minimum, edges.maximum};
  options.coordinate = document.style.coordinate;
  result_.aligned = align_features(document.mesh, target_.mesh, options, progress).aligned;
  round_as_written(document);
  if (result_.aligned > 0) agreement_.reset();
}

void MorphingLoop::finish(Document& document, const Progress& progress) {
  if (result_.stop == MorphingStop::iteration_limit) return conclude(document, progress);
  Document before = document;
  const MorphingResult result = result_;
  const std::optional<Agreement> agreement = agreement_;
  align(document, progress);
  conclude(document, progress);
  if (result_.aligned == 0) return;
  if (result_.agreement.fault.empty()) result_.stop = MorphingStop::converged;
  if (result.stop != MorphingStop::converged || result_.stop == result.stop) return;
  document = std::move(before);
  result_ = result;
  agreement_ = agreement;
  conclude(document, progress);
}

// Cleaning the last mesh may undo what was found before, unless there was nothing to clean.
void MorphingLoop::conclude(Document& document, const Progress& progress) {
  CleanedTopology cleaned;
  try {
    cleaned = clean_in_place(document, progress);
  } catch (const EmptyResultError&) {
    vanish(document.mesh);
  }
  result_.topology = cleaned.topology;
  MorphStepOptions at_rest;
  at_rest.distance = options_.step.distance;
  at_rest.goal = step_options().goal;
  at_rest.displace.alpha = 0;
  Mesh mesh = document.mesh;
  result_.distances = morph_step(mesh, query_, at_rest, progress);
  const bool is_converged = result_.stop == MorphingStop::converged;
  const bool is_known = is_converged && !cleaned.changed && agreement_.has_value();
  result_.agreement = is_known ? *agreement_ : agreement_of(document, result_.topology, progress);
  if (result_.agreement.fault.empty()) return;
  if (is_converged) result_.stop = MorphingStop::stalled;
  result_.remedy = remedy_for(query_, result_.agreement.mismatch);
  const std::string reason = reason_of(result_.remedy);
  if (!reason.empty()) result_.agreement.fault += "; " + reason;
}

MorphingOptions completed(MorphingOptions options, const Document& document) {
  options.iteration = completed(options.iteration, document.mesh);
  options.step.largest_size = options.iteration.reference_edge;
  if (options.step.gap_edges > 0) options.iteration.remesh.size_column = "size";
  return options;
}

}  // namespace

const char* name_of(MorphingStop stop) {
  if (stop == MorphingStop::converged) return "converged";
  return stop == MorphingStop::stalled ? "stalled" : "iteration_limit";
}

MorphingResult morph(Document& document, const Target& target, const MorphingOptions& options,
                     const LoopOptions& loop_options, Record& record, const Progress& progress) {
  const MorphingOptions complete = completed(options, document);
  MorphingLoop loop(target, complete, progress);
  try {
    run_loop(loop, document, loop_options, record, progress);
  } catch (const GoalError& error) {
    if (loop.remedy()) throw VanishedError(error.what(), *loop.remedy());
    throw;
  }
  MorphingResult result = loop.result();
  result.iterations = record.iteration();
  return result;
}

}  // namespace transformesh
