/// Decides whether a reconstruction has converged: it has if no fault is found.
#pragma once

#include <string>

#include "evolution/loop/loop_state.h"
#include "reconstruction/surface_doubt.h"

namespace transformesh {

/// Measures of the result by which convergence is decided, in addition to the sweeps.
struct SurfaceEvidence {
  double first_agreement = 1;  ///< overlap of initial mesh and exact masks; mean over the views
  double agreement = 1;        ///< overlap of result and exact masks; mean over the views
  SurfaceDoubt doubt;
};

/// Reasons why a reconstruction has not converged.
struct ReconstructionFaults {
  double lost_at = 0;       ///< scale after which less of the surface was compared; 0: none
  double late_at = 0;       ///< fine scale at which the topology changed; 0: none
  bool is_at_rest = false;  ///< true if the surface hardly moved in the last sweep

  /// Returns the first fault as a sentence, or "" if there is none. Besides the members above,
  /// three measures are faults. The outline agrees with masks by 0.005 less than that of the
  /// initial mesh. Photographs disagree by more than 0.2 beyond their noise, or on more than 3 % of
  /// the visible surface. A thin place is doubtful.
  std::string in_words(const SurfaceEvidence& evidence) const;
  void remember(LoopState& loop_state) {
    loop_state("lost", lost_at)("late", late_at)("rest", is_at_rest);
  }
};

}  // namespace transformesh
