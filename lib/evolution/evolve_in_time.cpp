#include "transformesh/evolve_in_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "evolution/bodies.h"
#include "evolution/end_rule.h"
#include "evolution/event_finder.h"
#include "evolution/integration.h"
#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/mesh_document.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/loop/stopwatch.h"
#include "evolution/recorded_loops.h"
#include "evolution/time_span.h"
#include "evolution/volume_keeper.h"
#include "mesh/local_measures.h"
#include "support/empty_result_error.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Bound for the relative rounding error of a sum of a million time spans. If the time until
/// `event_end_` is at most this fraction of the end time, it counts as 0. Otherwise a remainder of
/// that size would become a step of its own, which would be too short.
constexpr double rounding = 1e-9;

constexpr double infinite = std::numeric_limits<double>::infinity();

void check(const TimeOptions& options) {
  if (!(options.end > 0) || !std::isfinite(options.end))
    throw UsageError("the time at the end must be a positive number");
  if (!(options.span >= 0) || !std::isfinite(options.span))
    throw UsageError("the span of a step must be a positive number, or 0");
  if (!(options.max_move > 0)) throw UsageError("the largest movement must be positive");
  if (!options.bodies.empty() && !(options.gap > 0))
    throw UsageError("the gap between bodies that must not meet must be a positive length");
  if (!options.bodies.empty() && options.keep_volume)
    throw UsageError("the volume cannot be kept if there are several bodies");
  if (options.tolerance > 0 && options.integrator == Integrator::euler)
    throw UsageError(
        "Euler's method has no embedded method that estimates the error: use midpoint "
        "or rk4 with a tolerance");
}

TimeOptions completed(TimeOptions options) {
  check(options);
  if (options.event_tolerance < 0) options.event_tolerance = options.end / 1000;
  return options;
}

class TimeLoop : public Loop {
 public:
  TimeLoop(const Motion& motion, const TimeOptions& time, IterationOptions iteration,
           const UntilRule& until, bool finds_events)
      : motion_(motion), options_(time), iteration_(std::move(iteration)), end_rule_(until) {
    if (finds_events) events_.emplace().watch(iteration_);
  }

  void start(Document& document, const Progress& progress) override {
    topology_ = clean_all(document, progress);
    is_closed_ = check_manifold(document.mesh).is_closed();
    if (options_.keep_volume && !is_closed_)
      throw InputError("only a closed mesh has a volume to keep");
    split_edges(document, progress);
    is_done_ = document.mesh.faces.empty();
    if (events_) events_->start(document.mesh);
    measure_surface(document.mesh);
  }

  void advance(Document& document, std::size_t iteration, const Progress& progress) override {
    Stopwatch watch;
    const HalfedgeLengths edges = halfedge_lengths(document.mesh);
    const Document before = document;
    const Integration integration(motion_, before.mesh, time_, options_.integrator, progress);
    const double remaining = options_.end - time_;
    TrialStep step =
        chosen_step(integration, options_, remaining, longest_span(), edges.vertex_mean);
    if (!is_near_event()) next_span_ = next_span(step, options_);
    iterate_along(document, step, edges.mean, progress);
    while (changes_topology() && step.span > options_.event_tolerance &&
           options_.event_tolerance > 0) {
      event_end_ = time_ + step.span;
      ++repeated_;
      document = before;
      step = step_over(integration, step.span / 2, edges.vertex_mean);
      iterate_along(document, step, edges.mean, progress);
    }
    if (options_.keep_volume) restore_volume(document, progress);
    accept(document.mesh, step, remaining);
    if (events_) events_->end_step(document.mesh, iteration, time_);
    // `last_.seconds` includes computing the velocities, and all repeated trials of the step.
    last_.seconds = watch.lap();
    last_.seconds_step = last_.seconds - last_.seconds_clean - last_.seconds_remesh;
  }

  bool is_done() const override { return is_done_; }
  void finish(Document& document, const Progress& progress) override {
    if (!document.mesh.faces.empty()) clean_all(document, progress);
  }

  void remember(LoopState& loop_state) override {
    end_rule_.remember(loop_state);
    if (events_) events_->remember(loop_state);
    loop_state("done", is_done_)("time", time_)("span", span_)("next_span", next_span_)("event_end",
                                                                                        event_end_);
    loop_state("components", topology_.components)("genus", topology_.genus);
    loop_state("closed", is_closed_)("drift", drift_)("repeated", repeated_);
    loop_state("max_move", max_move_)("held_back", held_back_)("pairs", last_.pairs)(
        "was_cleaned", last_.was_cleaned);
  }

  void measure(CsvRow& row) const override {
    row.number("time", time_, 10).number("time_step", span_, 10);
    measure_mesh(last_, row);
    row.text("volume", is_closed_ ? significant(volume_, 12) : "").number("area", area_, 12);
    row.number("max_displacement", last_.displaced.max_displacement);
    row.number("rms_displacement", last_.displaced.rms_displacement);
    measure_times(last_, row);
  }

  std::string message() const override {
    return ": time " + significant(time_, 4) + ", " + in_words(last_.faces, last_.topology) +
           ", moved " + significant(last_.displaced.max_displacement, 3) + " at most";
  }

  std::vector<std::string> event_rows() const override {
    return events_ ? events_->last_rows() : std::vector<std::string>();
  }

  TimeResult result(std::size_t iterations, const Document& document) const {
    TimeResult result{time_, {iterations, is_done_, 0, 0, last_, {}, {}}};
    if (events_) events_->report(result.evolution);
    result.volume = volume(document.mesh);
    result.volume_drift = drift_;
    result.max_move = max_move_;
    result.held_back = held_back_;
    result.repeated = repeated_;
    return result;
  }

 private:
  bool changes_topology() const {
    return last_.topology != topology_ || (events_ && events_->has_found());
  }

  bool is_near_event() const { return event_end_ - time_ > rounding * options_.end; }

  /// Returns the upper limit of the time span of the next step. If the topology changes before
  /// `event_end_`, the limit is half the time until `event_end_`, so that bisection locates the
  /// event. If the time until `event_end_` is at most `event_tolerance`, the limit is all of it.
  double longest_span() const {
    if (is_near_event()) {
      const double gap = event_end_ - time_;
      return gap > options_.event_tolerance ? gap / 2 : gap;
    }
    const bool is_limited = motion_.displacement || options_.tolerance > 0;
    return is_limited && options_.span == 0 && next_span_ > 0 ? next_span_ : infinite;
  }

  BodyContact contact() const { return {options_.bodies, options_.gap}; }

  Topology clean_all(Document& document, const Progress& progress) {
    if (!options_.bodies.empty())
      return clean_bodies(document, contact(), iteration_.outermost, progress);
    return clean_in_place(document, progress, iteration_.outermost).topology;
  }

  /// Splits long edges of the source. `curved` changes the volume if it smooths large faces.
  void split_edges(Document& document, const Progress& progress) {
    IterationOptions splits = iteration_;
    // Vertices on curves could reach other bodies.
    if (!options_.bodies.empty()) splits.remesh.curved = false;
    const double before = volume(document.mesh);
    split_long_edges(document, splits, progress);
    if (is_closed_) drift_ = volume(document.mesh) - before;
  }

  void iterate_along(Document& document, const TrialStep& step, double mean_edge,
                     const Progress& progress) {
    iteration_.expects_changes = last_.was_cleaned;
    if (events_) events_->begin_step(document.mesh);
    if (!options_.bodies.empty()) {
      const BodiesResult result = iterate_bodies(
          document, step.integrated.displacements, contact(), iteration_,
          [&](ErrorKind kind) { return may_vanish(kind); }, progress);
      last_ = result.iteration;
      last_.displaced.mean_edge = mean_edge;
      remeshed_ = result.remeshed;
      return;
    }
    DisplaceResult displaced;
    double moved_volume = 0;
    const auto move = [&](Mesh& mesh, const Progress&) {
      const std::vector<Vec3>& displacements = step.integrated.displacements;
      displaced = move_vertices(mesh, displacements, mean_edge);
      if (options_.keep_volume) keeper_.begin(mesh, displacements);
      moved_volume = volume(mesh);
      return displaced;
    };
    try {
      last_ = iterate(document, move, iteration_, progress);
    } catch (const GoalError& error) {
      if (!may_vanish(error.kind())) throw;
      document.mesh = select_faces(document.mesh, std::vector<bool>(document.mesh.faces.size()));
      last_ = {};
      last_.displaced = displaced;
      last_.was_cleaned = true;
    }
    remeshed_ = last_.was_cleaned ? 0 : volume(document.mesh) - moved_volume;
  }

  /// True if the error of a step means that the surface has shrunk to nothing. If steps are not
  /// repeated with shorter spans, the surface may also have turned inside out in a long step.
  bool may_vanish(ErrorKind kind) const {
    const bool is_located = options_.event_tolerance > 0 || kind != ErrorKind::surface_vanished;
    return is_nothing_left(kind) && is_located;
  }

  void restore_volume(Document& document, const Progress& progress) {
    if (keeper_.restore(document)) last_.topology = clean_all(document, progress);
    drift_ += volume(document.mesh) - keeper_.volume();
  }

  void accept(const Mesh& mesh, const TrialStep& step, double remaining) {
    const bool is_end = step.span >= remaining;
    time_ = is_end ? options_.end : time_ + step.span;
    span_ = step.span;
    max_move_ = std::max(max_move_, step.max_move);
    held_back_ = std::max(held_back_, last_.displaced.held_back);
    topology_ = last_.topology;
    is_done_ = is_end || mesh.faces.empty() || end_rule_.add(last_);
    measure_surface(mesh);
    if (!options_.keep_volume && is_closed_) drift_ += remeshed_;
  }

  void measure_surface(const Mesh& mesh) {
    volume_ = volume(mesh);
    area_ = surface_area(mesh);
  }

  const Motion& motion_;
  TimeOptions options_;
  IterationOptions iteration_;
  EndRule end_rule_;
  std::optional<EventFinder> events_;
  VolumeKeeper keeper_;
  IterationResult last_;
  Topology topology_;
  double time_ = 0, event_end_ = 0;
  double span_ = 0;       ///< time span of the last step
  double next_span_ = 0;  ///< result of next_span() for the last step that was not near an event
  double volume_ = 0, area_ = 0, drift_ = 0, max_move_ = 0;
  double remeshed_ = 0;  ///< change of volume by remeshing in the last step, without cleaning
  std::size_t repeated_ = 0, held_back_ = 0;
  bool is_closed_ = false, is_done_ = false;
};

}  // namespace

TimeResult evolve_in_time(Document& document, const Motion& motion, const TimeOptions& time,
                          const EvolveOptions& options, const LoopOptions& loop_options,
                          Record& record, const Progress& progress) {
  IterationOptions iteration = completed(options.iteration, document.mesh);
  // A cavity of a body may hold another body. If it were filled, both bodies would overlap.
  if (!time.bodies.empty()) iteration.outermost = false;
  TimeLoop loop(motion, completed(time), iteration, options.until,
                options.finds_events || record.has_events());
  run_loop(loop, document, loop_options, record, progress);
  return loop.result(record.iteration(), document);
}

TimeResult evolve_in_time(Document& document, const Motion& motion, const TimeOptions& time,
                          const EvolveOptions& options, const LoopOptions& loop,
                          const Progress& progress) {
  Record record(loop.record);
  return evolve_in_time(document, motion, time, options, loop, record, progress);
}

TimeResult evolve_in_time(Mesh& mesh, const Motion& motion, const TimeOptions& time,
                          const EvolveOptions& options, const LoopOptions& loop,
                          const Progress& progress) {
  return with_document(mesh, [&](Document& document) {
    return evolve_in_time(document, motion, time, options, loop, progress);
  });
}

}  // namespace transformesh
