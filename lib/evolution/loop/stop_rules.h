/// Rules that end an evolution (paper 5.2). Each receives numbers per iteration and returns a
/// verdict. Rules store the best values so far (loop_state.h).
#pragma once

#include <cstddef>

#include "evolution/loop/loop_state.h"
#include "transformesh/morph_step.h"

namespace transformesh {

/// The smallest value so far. Improvements by less than a hundredth do not count.
struct Best {
  double value = -1;  ///< negative: none yet
  /// Takes `next` if it is an improvement, and returns whether it is.
  bool takes(double next);
};

/// Ends if a value has not improved by a hundredth for `patience` iterations.
class StalledRule {
 public:
  explicit StalledRule(std::size_t patience = 20) : patience_(patience) {}
  /// Adds the value of an iteration, where lower is better. Returns true if the evolution stalls.
  bool add(double value);
  void remember(LoopState& loop_state) { loop_state("best", best_.value)("idle", idle_); }

 private:
  std::size_t patience_;
  Best best_;
  std::size_t idle_ = 0;
};

enum class MorphVerdict {
  go_on,
  /// Refine the edges. Returned at a coarse scale if at most one in a hundred vertices was clamped,
  /// or if nothing improved for five iterations.
  refine,
  /// Compare the mesh with the target, and end if they agree. Returned if no vertex moves by more
  /// than half its clamp and the vertices of mesh and target lie on the other surface. This means:
  /// root mean square distances are below half the mean edge, and no target vertex is farther away
  /// than two mean edges. Returned at most every fifth iteration, since a comparison takes longer
  /// than an iteration.
  examine,
  /// Compare the mesh with the target, and end in any case. Returned if nothing improved by a
  /// hundredth for 20 iterations, or for three if no vertex moves, and the vertices lie on the
  /// other surface. At a sharp tip, for example, step and smoothing may move a vertex back and
  /// forth.
  examine_last,
  /// End without agreement: as `examine_last`, but the vertices do not lie on the other surface.
  stalled
};

class MorphRule {
 public:
  /// Begins at scale `scales` - 1. Edges at scale s are 2^s times as long; the last scale is 0.
  explicit MorphRule(int scales = 1) : scale_(scales - 1) {}

  int scale() const { return scale_; }
  /// Adds the step of an iteration and the number of its vertices. If the verdict is `refine`, the
  /// scale is then the next finer one.
  MorphVerdict add(const MorphStepResult& step, std::size_t vertices);
  /// Continues at the next finer scale, if an iteration at this scale leaves no surface.
  void skip_scale() { --scale_; }
  void remember(LoopState& loop_state);

 private:
  bool has_improved(const MorphStepResult& step);
  MorphVerdict verdict(const MorphStepResult& step, std::size_t vertices) const;

  int scale_;
  std::size_t idle_ = 0;  ///< iterations without improvement
  std::size_t age_ = 0;   ///< iterations of this scale
  /// Iterations since the last comparison with the target; starts high, so that the first
  /// comparison may be made at once.
  std::size_t unexamined_ = 100;
  Best rms_to_target_, max_to_target_, rms_from_target_, max_from_target_, max_clamp_share_;
};

}  // namespace transformesh
