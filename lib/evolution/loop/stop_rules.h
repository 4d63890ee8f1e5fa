/// When an evolution has come to its end (paper 5.2): plain values in, a verdict out. Rules
/// remember what was best so far (loop_state.h).
#pragma once

#include <cstddef>

#include "evolution/loop/loop_state.h"
#include "step/morph_step.h"

namespace transformesh {

/// The smallest of the values so far, but for those that were smaller by less than a hundredth.
struct Best {
  double value = -1;  ///< negative: none yet
  /// Whether it becomes the next.
  bool takes(double next);
};

/// Nothing got better by a hundredth in so many iterations.
class StalledRule {
 public:
  explicit StalledRule(std::size_t patience = 20) : patience_(patience) {}
  /// With the value that is to become small; true: stalled.
  bool add(double value);
  void remember(LoopState& loop_state) { loop_state("best", best_.value)("idle", idle_); }

 private:
  std::size_t patience_;
  Best best_;
  std::size_t idle_ = 0;
};

enum class MorphVerdict {
  go_on,
  /// At a coarse scale: at most one in a hundred vertices would go farther than its clamp, or
  /// nothing got better for five iterations.
  refine,
  /// No vertex moves more than half its clamp, and the vertices of mesh and target lie on the
  /// other: root mean squares below half the mean edge, no point of the target missed by two edges.
  /// At most every fifth iteration, as looking costs more than an iteration.
  examine,
  /// Nothing got better by a hundredth in 20 iterations, or in three where no vertex moves any
  /// more; but the vertices lie on the other: at a sharp tip the step and the smoothing may pull a
  /// vertex to and fro for ever.
  examine_last,
  /// The same, and they do not.
  stalled
};

class MorphRule {
 public:
  /// Scale s has edges 2^s times as long; the last is 0.
  explicit MorphRule(int scales = 1) : scale_(scales - 1) {}

  int scale() const { return scale_; }
  /// With the step of an iteration, and how many vertices took it. After `refine` the scale is the
  /// next finer one.
  MorphVerdict add(const MorphStepResult& step, std::size_t vertices);
  /// Where a coarse scale has no edges for what is left: goes on as before with the next finer one.
  void skip_scale() { --scale_; }
  void remember(LoopState& loop_state);

 private:
  bool has_improved(const MorphStepResult& step);
  MorphVerdict verdict(const MorphStepResult& step, std::size_t vertices) const;

  int scale_;
  std::size_t idle_ = 0;          ///< iterations without improvement
  std::size_t age_ = 0;           ///< iterations of this scale
  std::size_t unexamined_ = 100;  ///< iterations since the one that was examined last
  Best rms_to_target_, max_to_target_, rms_from_target_, max_from_target_, max_clamp_share_;
};

}  // namespace transformesh
