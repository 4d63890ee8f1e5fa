/// Whether a surface that was tracked through a movie is as good as one that was made anew.
#pragma once

#include <string>

#include "evolution/loop/loop_state.h"

namespace transformesh {

/// How good the surface of a time step is.
struct SurfaceQuality {
  double dissimilarity = 3;  ///< no surface has more than 2: one that was lost has all faults
  double coverage = 0;
  double least_agreement = 0;  ///< with a silhouette, over the views

  void remember(LoopState& loop_state) {
    loop_state("dissimilarity", dissimilarity)("coverage", coverage)("agreement", least_agreement);
  }
};

/// What is worse than in the last surface that did not begin with the one before: `dissimilarity`
/// by 1.3 times, `coverage` by a tenth, `silhouettes` by 0.03; joined by +.
std::string tracking_faults(const SurfaceQuality& surface, const SurfaceQuality& reference);

/// Whether a surface made anew is better than the one that was tracked: fewer faults, or as many
/// and less dissimilarity.
bool is_better(const SurfaceQuality& anew, const SurfaceQuality& tracked,
               const SurfaceQuality& reference);

}  // namespace transformesh
