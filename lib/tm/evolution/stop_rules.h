/// When an evolution has come to its end (paper 5.2): plain values in, a verdict out. Rules
/// remember what was best so far, as values that a state can hold (state.h).
#pragma once

#include <cstddef>

#include "tm/evolution/state.h"

namespace transformesh {

/// Nothing got better by a hundredth in so many iterations.
class StalledRule {
 public:
  explicit StalledRule(std::size_t patience = 20) : patience_(patience) {}
  /// With the value that is to become small; true: stalled.
  bool add(double value);

  Values values() const { return {{"best", best_}, {"idle", static_cast<double>(idle_)}}; }
  void restore(const Values& values);

 private:
  std::size_t patience_;
  double best_ = -1;  ///< negative: none yet
  std::size_t idle_ = 0;
};

/// What the rule of a morph looks at; lengths in input units, distances before the iteration.
struct MorphMeasures {
  std::size_t iteration = 1;  ///< counts from 1
  std::size_t vertices = 0;
  std::size_t clamped = 0;     ///< vertices that wanted to go farther than their clamp
  double max_clamp_share = 0;  ///< largest movement as a fraction of the vertex's own clamp
  double rms_to_target = 0, max_to_target = 0;
  double rms_from_target = 0, max_from_target = 0;
  double mean_edge = 0;
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
  /// After `refine` the scale is the next finer one.
  MorphVerdict add(const MorphMeasures& measures);
  /// Where a coarse scale has no edges for what is left: goes on as before with the next finer one.
  void skip_scale() { --scale_; }

  Values values() const;
  void restore(const Values& values);

 private:
  bool improves(const char* name, double value);
  bool has_improved(const MorphMeasures& measures);
  MorphVerdict verdict(const MorphMeasures& measures) const;
  void begin_finer_scale();

  int scale_;
  std::size_t idle_ = 0;  ///< iterations without improvement
  std::size_t age_ = 0;   ///< iterations of this scale
  double examined_ = -9;  ///< the iteration that was examined last
  Values best_;
};

}  // namespace transformesh
