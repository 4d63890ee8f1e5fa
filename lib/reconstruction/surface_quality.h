/// Compares a tracked surface of a movie with one that was reconstructed from its hull.
#pragma once

#include <string>

#include "evolution/loop/loop_state.h"

namespace transformesh {

/// Quality of the surface of a time step.
struct SurfaceQuality {
  double dissimilarity = 3;  ///< at most 2 for any surface; a lost surface is worse
  double coverage = 0;
  double least_agreement = 0;  ///< least agreement with a silhouette, over the views

  void remember(LoopState& loop_state) {
    loop_state("dissimilarity", dissimilarity)("coverage", coverage)("agreement", least_agreement);
  }
};

/// Returns the measures that are worse than in `reference`, the last surface that was not tracked,
/// joined by +. `dissimilarity` is worse above 1.3 times the reference, `coverage` below nine
/// tenths of it, and the agreement (`silhouettes`) if it is lower by more than 0.03.
std::string tracking_faults(const SurfaceQuality& surface, const SurfaceQuality& reference);

/// True if the surface `anew`, reconstructed from its hull, is better than the tracked one: it has
/// fewer faults, or as many and less dissimilarity.
bool is_better(const SurfaceQuality& anew, const SurfaceQuality& tracked,
               const SurfaceQuality& reference);

}  // namespace transformesh
