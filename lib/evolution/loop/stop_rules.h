/// Rules that end an evolution (paper 5.2). Each rule receives numbers of an iteration, and decides
/// whether to end. Rules store the best values so far (loop_state.h).
#pragma once

#include <cstddef>

#include "evolution/loop/loop_state.h"
#include "transformesh/morph_step.h"

namespace transformesh {

/// The smallest of several values. Improvements by less than a hundredth do not count.
struct Best {
  double value = -1;  ///< best value so far; negative if there is none
  /// Stores `next` if it is an improvement, and returns whether it is one.
  bool takes(double next);
};

/// Ends an evolution if a value has not improved by a hundredth for `patience` iterations.
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
  /// Continue with shorter edges. Returned at a coarse scale if at most one in a hundred vertices
  /// was clamped (its movement was limited), or if nothing improved for five iterations.
  refine,
  /// Compare the mesh with the target, and end if they agree. Returned at most every fifth
  /// iteration, since a comparison takes longer than an iteration. There are two conditions. No
  /// vertex moves by more than half its clamp, the limit of its movement. The vertices of mesh and
  /// target are close to the other surface. Close means that root mean square distances are below
  /// half the mean edge, and that no target vertex is farther away than two mean edges.
  examine,
  /// Compare the mesh with the target, and end in any case. Returned if the vertices are close to
  /// the other surface, as for `examine`, and nothing improved by a hundredth for 20 iterations. If
  /// no vertex moves, three iterations are enough. Otherwise vertices may still move: at a sharp
  /// tip, for example, step and smoothing may move a vertex back and forth.
  examine_last,
  /// End, because nothing improved for as many iterations as for `examine_last`, but the vertices
  /// are not close to the other surface.
  stalled
};

class MorphRule {
 public:
  /// Begins at scale `scales` - 1 and ends at scale 0. At scale s, edges are 2^s times as long as
  /// at scale 0.
  explicit MorphRule(int scales = 1) : scale_(scales - 1) {}

  int scale() const { return scale_; }
  /// Adds the result of an iteration's step, and the number of its vertices. If the verdict is
  /// `refine`, scale() is then the next finer scale.
  MorphVerdict add(const MorphStepResult& step, std::size_t vertices);
  /// Continues at the next finer scale. Call this if an iteration at the current scale leaves no
  /// surface.
  void skip_scale() { --scale_; }
  void remember(LoopState& loop_state);

 private:
  bool has_improved(const MorphStepResult& step);
  MorphVerdict verdict(const MorphStepResult& step, std::size_t vertices) const;

  int scale_;
  std::size_t idle_ = 0;  ///< number of consecutive iterations without improvement
  std::size_t age_ = 0;   ///< number of iterations at the current scale
  /// Number of iterations since the last comparison with the target. Starts high, so that the first
  /// comparison may be made at once.
  std::size_t unexamined_ = 100;
  Best rms_to_target_, max_to_target_, rms_from_target_, max_from_target_, max_clamp_share_;
};

}  // namespace transformesh
