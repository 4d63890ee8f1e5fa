/// When a scale of coarse to fine is done (paper 5.3.1): plain values of its sweeps in, a verdict
/// out. What it remembers of them is kept in the record of a run.
#pragma once

#include <cstddef>

#include "evolution/loop/loop_state.h"
#include "reconstruction/image_scales.h"
#include "transformesh/iteration.h"
#include "views/photo/photo_steps.h"

namespace transformesh {

/// Measures of a finished sweep.
struct Sweep {
  ScaleStep scale_step;
  IterationResult mesh;
  PhotoStepsResult steps;
};

/// Below 2: where the topology should be found, and photographs show what is thin.
bool is_late_scale(double scale);

struct SweepVerdict {
  bool is_done = false;     ///< go on with the next scale
  bool is_at_rest = false;  ///< hardly moves, and neither enters silhouettes nor changes topology
  /// Since the scale began the share of pixels that are compared fell by a tenth, or their number
  /// by half: a surface that photographs agree on because less of it is compared.
  bool is_lost = false;
  /// Components or holes came or went at a scale below 2: thin sheets and necks do, and photographs
  /// hold none.
  bool is_late = false;
};

/// When a scale of coarse to fine is done: where vertices move by less than 1.5 % of an edge or
/// photographs agree by less than a hundredth better than after the sweep before, or after so many
/// sweeps; but while vertices come in from outside of silhouettes or the topology changes, not
/// before twice as many.
class ScaleRule {
 public:
  explicit ScaleRule(std::size_t sweeps = 4) : sweeps_(sweeps) {}

  SweepVerdict add(const Sweep& sweep);
  /// A scale begins.
  void begin() { *this = ScaleRule(sweeps_); }
  /// After the last sweep, with the six digits that the rule remembers.
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
  double coverage_ = 0;  ///< that the scale began with
  std::size_t pixels_ = 0;
};

}  // namespace transformesh
