#include "transformesh/morph.h"

#include <algorithm>
#include <cmath>

#include "evolution/agreement.h"
#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/loop/stop_rules.h"
#include "evolution/loop/stopwatch.h"
#include "evolution/morph_remedy.h"
#include "evolution/recorded_loops.h"
#include "io/document/round_as_written.h"
#include "step/local_thickness.h"
#include "step/morph_step_query.h"
#include "step/target_query.h"
#include "support/empty_result_error.h"
#include "support/number.h"
#include "transformesh/align_features.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

std::optional<Target> measured(const Target& target, const MorphOptions& options,
                               const Progress& progress) {
  if (options.step.gap_edges == 0 || !target.thickness.empty()) return std::nullopt;
  return with_thickness(target, options.step.gap_edges, options.iteration.reference_edge, progress);
}

class MorphingLoop : public Loop {
 public:
  MorphingLoop(const Target& target, const MorphOptions& options, const Progress& progress)
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
  bool is_done() const override { return result_.stop != MorphStop::iteration_limit; }
  void finish(Document& document, const Progress& progress) override;

  void remember(LoopState& loop_state) override {
    rule_.remember(loop_state);
    loop_state("stop", result_.stop);
  }
  void measure(CsvRow& row) const override;
  std::string message() const override;

  const MorphResult& result() const { return result_; }

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
  bool has_uniform_edges() const { return options_.step.gap_edges == 0; }
  [[noreturn]] void vanish(const Mesh& mesh) const;

  const Target& target_;
  /// The target with local thickness, if the options need it and `target` does not have it.
  const std::optional<Target> measured_;
  const TargetQuery query_;
  const MorphOptions& options_;
  MorphRule rule_;
  const MorphGoal goal_;
  MorphResult result_;

  // Data of the last iteration.
  int scale_ = 0;
  MorphStepResult step_;
  IterationResult last_;
  /// Comparison of the mesh with the target, if the last iteration made one.
  std::optional<Agreement> agreement_;
};

// Makes an iteration at the current scale (edge length times a power of two). If `remeshes_first`,
// the mesh is first remeshed to the edges of this scale, which makes steps shorter. Returns false
// if the iteration fails and another attempt is possible.
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
  } catch (const GoalError& error) {
    if (!is_last) return false;
    if (is_nothing_left(error.kind())) vanish(document.mesh);
    throw;
  }
}

void MorphingLoop::vanish(const Mesh& mesh) const {
  const Problem cause =
      cause_of_vanishing(target_, edge_lengths(mesh).maximum, has_uniform_edges());
  const std::string what = "the surface shrinks to nothing";
  throw GoalError(cause.kind, cause.sentence.empty() ? what : what + ": " + cause.sentence,
                  cause.data);
}

// Makes an iteration. If it fails, tries finer scales (shorter edges), and shorter steps after
// remeshing. At a coarse scale, edges may be longer than the surface is wide, or steps may turn the
// surface inside out.
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
  if (is_last) result_.stop = MorphStop::stalled;
  agreement_.reset();
  if (verdict != MorphVerdict::examine && verdict != MorphVerdict::examine_last) return;
  agreement_ = agreement_of(document, last_.topology, progress);
  if (agreement_->fault.empty()) result_.stop = MorphStop::converged;
}

void MorphingLoop::measure(CsvRow& row) const {
  measure_mesh(last_, row);
  row.share("moved_fraction", transformesh::moved_share(last_));
  row.share("max_clamp_share", step_.displaced.max_clamp_share);
  row.number("rms_distance_to_target", step_.to_target.rms);
  row.number("max_distance_to_target", step_.to_target.maximum);
  row.number("rms_distance_from_target", step_.from_target.rms);
  row.number("max_distance_from_target", step_.from_target.maximum);
  measure_times(last_, row);
  row.count("scale", scale_).share("clamped_fraction", transformesh::clamped_share(last_));
}

std::string MorphingLoop::message() const {
  return ": " + in_words(last_.faces, last_.topology) + ", moved " +
         std::to_string(static_cast<int>(100 * transformesh::moved_share(last_))) + "%, distance " +
         significant(std::max(step_.to_target.rms, step_.from_target.rms), 3);
}

// Aligns edges of the mesh with the sharp edges of the target. Called after the last iteration, so
// that smoothing does not round off these edges.
void MorphingLoop::align(Document& document, const Progress& progress) {
  const bool may_align = target_.is_mesh() && options_.features != Features::off;
  if (!may_align || (options_.features == Features::automatic && !has_features(target_.mesh)))
    return;
  const EdgeLengths edges = edge_lengths(document.mesh);
  AlignOptions options;
  options.min_edge = edges.minimum;
  options.max_edge = edges.maximum;
  options.coordinate = document.style.coordinate;
  result_.aligned = align_features(document.mesh, target_.mesh, options, progress).aligned;
  round_as_written(document);
  if (result_.aligned > 0) agreement_.reset();
}

void MorphingLoop::finish(Document& document, const Progress& progress) {
  if (result_.stop == MorphStop::iteration_limit) return conclude(document, progress);
  Document before = document;
  const MorphResult result = result_;
  const std::optional<Agreement> agreement = agreement_;
  align(document, progress);
  conclude(document, progress);
  if (result_.aligned == 0) return;
  if (result_.fault.empty()) result_.stop = MorphStop::converged;
  if (result.stop != MorphStop::converged || result_.stop == result.stop) return;
  document = std::move(before);
  result_ = result;
  agreement_ = agreement;
  conclude(document, progress);
}

// Cleans the final mesh and compares it with the target. If cleaning changed nothing, uses the
// comparison that the last iteration made.
void MorphingLoop::conclude(Document& document, const Progress& progress) {
  CleanedTopology cleaned;
  try {
    cleaned = clean_in_place(document, progress);
  } catch (const GoalError& error) {
    if (is_nothing_left(error.kind())) vanish(document.mesh);
    throw;
  }
  result_.topology = cleaned.topology;
  MorphStepOptions at_rest;
  at_rest.distance = options_.step.distance;
  at_rest.goal = step_options().goal;
  at_rest.displace.alpha = 0;
  Mesh mesh = document.mesh;
  result_.distances = morph_step(mesh, query_, at_rest, progress);
  const bool is_converged = result_.stop == MorphStop::converged;
  const bool is_known = is_converged && !cleaned.changed && agreement_.has_value();
  const Agreement found =
      is_known ? *agreement_ : agreement_of(document, result_.topology, progress);
  result_.fault = found.fault;
  result_.to_target = found.to_target;
  result_.from_target = found.from_target;
  if (found.fault.empty()) return;
  if (is_converged) result_.stop = MorphStop::stalled;
  Mismatch mismatch = found.mismatch;
  mismatch.has_uniform_edges = has_uniform_edges();
  result_.cause = cause_of(query_, mismatch);
  const std::string& reason = result_.cause.sentence;
  if (!reason.empty()) result_.fault += "; " + reason;
}

MorphOptions completed(MorphOptions options, const Document& document) {
  options.iteration = completed(options.iteration, document.mesh);
  options.step.largest_size = options.iteration.reference_edge;
  if (options.step.gap_edges > 0) options.iteration.remesh.size_column = "size";
  return options;
}

}  // namespace

const char* name_of(MorphStop stop) {
  if (stop == MorphStop::converged) return "converged";
  return stop == MorphStop::stalled ? "stalled" : "iteration_limit";
}

MorphResult morph(Document& document, const Target& target, const MorphOptions& options,
                  const LoopOptions& loop_options, Record& record, const Progress& progress) {
  const MorphOptions complete = completed(options, document);
  MorphingLoop loop(target, complete, progress);
  run_loop(loop, document, loop_options, record, progress);
  MorphResult result = loop.result();
  result.iterations = record.iteration();
  return result;
}

MorphResult morph(Document& document, const Target& target, const MorphOptions& options,
                  const LoopOptions& loop, const Progress& progress) {
  Record record(loop.record);
  return morph(document, target, options, loop, record, progress);
}

}  // namespace transformesh
