/// Finds the events of an evolution, step by step (events.h). A loop calls watch() and start()
/// once, begin_step() before each trial of a step, and end_step() when a trial is accepted. A step
/// that is repeated is thus reported once.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "evolution/loop/loop_state.h"
#include "evolution/topology_change.h"
#include "transformesh/evolve.h"

namespace transformesh {

class EventFinder {
 public:
  /// Labels the components of the initial mesh.
  void start(Mesh& mesh);

  /// Begins a trial of a step. Discards the events of an earlier trial of the same step.
  void begin_step(const Mesh& mesh);

  /// Sets IterationOptions::on_cleaned, so that iterate() passes the meshes before and after
  /// cleaning. The finder must outlive the options.
  void watch(IterationOptions& options);

  /// Accepts the trial. `mesh` is the mesh at its end.
  void end_step(const Mesh& mesh, std::size_t iteration, double time);

  /// Returns the CSV rows of the events of the last step.
  std::vector<std::string> last_rows() const;

  /// True if the current trial of a step has found an event. Call before end_step().
  bool has_found() const { return !found_.empty(); }

  void report(EvolveResult& result) const {
    result.events = events_;
    result.event_count = event_count_;
  }

  void remember(LoopState& loop_state) {
    loop_state("next_label", next_label_)("events", event_count_);
  }

 private:
  /// Compares a mesh before and after cleaning. If bodies are cleaned one by one (bodies.h), these
  /// are the meshes of a body.
  void see(const Mesh& moved, Mesh& cleaned);
  bool is_brief(const Event& event, const std::set<long>& labels) const;
  void measure_before();
  void add_vanished(const Mesh& mesh);

  /// Volume of a ball whose diameter is the shortest allowed edge; 0: not set.
  double least_volume_ = 0;
  long next_label_ = 1, label_after_step_ = 1;
  Mesh before_;  ///< positions, faces and labels at the beginning of the step
  /// States of the components of `before_`; empty until needed.
  std::optional<LabeledStates> begun_;
  LabeledStates now_;          ///< states of the components after the last cleaning
  std::vector<Event> found_;   ///< events found in the current trial of a step
  std::vector<Event> events_;  ///< events of all accepted steps
  std::size_t events_before_step_ = 0, event_count_ = 0;
};

}  // namespace transformesh
