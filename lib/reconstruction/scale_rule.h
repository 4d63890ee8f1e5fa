/// Decides when a scale of a reconstruction is finished (paper 5.3.1), from measures of its sweeps.
/// The state of the rule is stored in the record of a run.
#pragma once

#include <cstddef>

#include "evolution/loop/loop_state.h"
#include "reconstruction/image_scales.h"
#include "transformesh/iteration.h"
#include "views/photo/photo_steps.h"

namespace transformesh {

/// Measures of a finished sweep, which is one iteration of a reconstruction: some steps of the
/// surface at one scale of the photographs.
struct Sweep {
  ScaleStep scale_step;
  IterationResult mesh;
  PhotoStepsResult steps;
};

/// True if the scale is below 2. The topology should not change any more at such scales, because
/// thin parts are visible in photographs from scale 2 on.
bool is_late_scale(double scale);

/// Returns a count as a real number, for comparison with a fraction of another count.
inline double real_count(std::size_t count) { return static_cast<double>(count); }

struct SweepVerdict {
  bool is_done = false;  ///< true if the sweeps at this scale are finished
  /// True if vertices hardly move or the dissimilarity hardly falls, no vertices enter silhouettes
  /// from outside, the topology did not change, and `is_lost` is false.
  bool is_at_rest = false;
  /// True if fewer pixels are compared than in the first sweep of the scale: their fraction of the
  /// visible pixels fell by a tenth, or their number fell by half. Photographs may then agree only
  /// because less of the surface is compared.
  bool is_lost = false;
  /// True if the number of components or handles changed at a scale below 2. Such changes are
  /// typical of thin sheets and necks that no photograph confirms.
  bool is_late = false;
};

/// Decides after each sweep whether the scale is finished. It is finished after `sweeps` sweeps. If
/// vertices enter silhouettes from outside or the topology changes, it is only finished after `2 *
/// sweeps` sweeps. The same holds for the last scale, because no finer scale continues the
/// movement. A scale is finished earlier if SweepVerdict::is_at_rest is true. Vertices hardly move
/// if they move by less than 1.5 % of an edge on average. The dissimilarity hardly falls if it
/// falls by less than 1 % from one sweep to the next.
class ScaleRule {
 public:
  explicit ScaleRule(std::size_t sweeps = 4) : sweeps_(sweeps) {}

  SweepVerdict add(const Sweep& sweep, bool is_last = false);
  /// Prepares the rule for a new scale.
  void begin() { *this = ScaleRule(sweeps_); }
  /// Returns the dissimilarity after the last sweep, rounded to six digits as in the record.
  double dissimilarity() const { return before_.dissimilarity; }

  void remember(LoopState& loop_state);

 private:
  std::size_t sweeps_;
  std::size_t done_ = 0;
  struct LastSweep {
    double dissimilarity = 0;
    std::size_t outside = 0;
    Topology topology;
  };
  LastSweep before_;
  double coverage_ = 0;     ///< PhotoStepResult::coverage when the scale began
  std::size_t pixels_ = 0;  ///< number of compared pixels when the scale began
};

}  // namespace transformesh
