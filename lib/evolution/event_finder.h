/// Finds the events of an evolution, step by step (events.h). A loop calls start() once,
/// begin_step() before each trial of a step, watch() from iterate(), and end_step() when the step
/// is accepted: a step that is repeated is reported once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evolution/loop/loop_state.h"
#include "evolution/topology_change.h"
#include "transformesh/evolve.h"

namespace transformesh {

class EventFinder {
 public:
  /// Labels the components of the mesh at the start.
  void start(Mesh& mesh);

  /// Forgets what an earlier trial of the step found.
  void begin_step(const Mesh& mesh);

  /// Makes iterate() show the mesh before and after cleaning. The finder has to outlive the
  /// options.
  void watch(IterationOptions& options);

  /// Call with the mesh at the end of the accepted step.
  void end_step(const Mesh& mesh, std::size_t iteration, double time);

  /// Rows of the events of the last step.
  std::vector<std::string> last_rows() const;

  /// True if an event has been found in the trial of a step, before end_step().
  bool has_found() const { return !found_.empty(); }

  void report(EvolveResult& result) const {
    result.events = events_;
    result.event_count = event_count_;
  }

  void remember(LoopState& loop_state) {
    loop_state("next_label", next_label_)("events", event_count_);
  }

 private:
  void see(const Mesh& moved, Mesh& cleaned);
  void measure_before();
  void add_vanished(const Mesh& mesh);

  long next_label_ = 1, label_after_step_ = 1;
  Mesh before_;                         ///< positions, faces and labels when the step began
  std::optional<LabeledStates> begun_;  ///< components then, measured when they are needed
  LabeledStates now_;                   ///< components after the last cleaning
  std::vector<Event> found_;            ///< in the trial
  std::vector<Event> events_;
  std::size_t events_before_step_ = 0, event_count_ = 0;
};

}  // namespace transformesh
