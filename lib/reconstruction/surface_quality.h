/// Compares surfaces of one time step of a movie: a tracked surface, which began with the previous
/// one, and a surface that was reconstructed from its visual hull.
#pragma once

#include <string>

#include "evolution/loop/loop_state.h"

namespace transformesh {

/// Quality of the surface of a time step.
struct SurfaceQuality {
  /// At most 2 for any surface; the default is worse and means that there is no surface.
  double dissimilarity = 3;
  double coverage = 0;
  /// Least intersection over union of outline and silhouette in a view.
  double least_agreement = 0;

  void remember(LoopState& loop_state) {
    loop_state("dissimilarity", dissimilarity)("coverage", coverage)("agreement", least_agreement);
  }
};

/// Returns the names of the measures that are worse than in `reference`, joined by "+". `reference`
/// is the last surface that was not tracked. `dissimilarity` is worse above 1.3 times the
/// reference, and `coverage` below 0.9 times the reference. `least_agreement`, named "silhouettes",
/// is worse if it is lower by more than 0.03.
std::string tracking_faults(const SurfaceQuality& surface, const SurfaceQuality& reference);

/// True if the surface `anew`, reconstructed from its hull, is better than the tracked one. It is
/// better if it has fewer faults, or equally many faults and less dissimilarity.
bool is_better(const SurfaceQuality& anew, const SurfaceQuality& tracked,
               const SurfaceQuality& reference);

}  // namespace transformesh
