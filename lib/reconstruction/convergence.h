/// Decides whether a reconstruction has converged. It has converged if it has none of the faults
/// below.
#pragma once

#include <string>

#include "evolution/loop/loop_state.h"
#include "reconstruction/surface_doubt.h"

namespace transformesh {

/// Measures of the resulting surface by which convergence is decided. ReconstructionFaults contains
/// further reasons, from the sweeps.
struct SurfaceEvidence {
  /// Mean intersection over union of the outlines of the initial mesh and exact masks.
  double first_agreement = 1;
  /// Mean intersection over union of the outlines of the result and exact masks.
  double agreement = 1;
  SurfaceDoubt doubt;
};

/// Reasons why a reconstruction has not converged.
struct ReconstructionFaults {
  /// Scale at which the part of the surface on which photographs can be compared became smaller
  /// (SweepVerdict::is_lost); 0: none.
  double lost_at = 0;
  double late_at = 0;       ///< scale below 2 at which components or handles changed; 0: none
  bool is_at_rest = false;  ///< true if the surface hardly moved in the last sweep
  double exploded_at = 0;   ///< scale at which the surface fell apart (is_exploded()); 0: none

  /// Returns the first fault as a sentence, or "" if there is none. Besides the members above,
  /// nine conditions are faults. The overlap of outlines and exact masks is more than 0.005 below
  /// that of the initial mesh. Photographs disagree by more than 0.18 beyond their noise. A
  /// doubtful place has a handle, or is thin (surface_doubt.h). Fewer than two views observe a thin
  /// sheet or fin. Hidden places (hidden_vertices.h) are more than 0.5 % of the surface. Doubtful
  /// places are more than 3 % of the observed surface. Those of small windows are more than 1.5 %.
  /// A place fills a hollow (filled_hollows.h).
  std::string in_words(const SurfaceEvidence& evidence) const;
  void remember(LoopState& loop_state) {
    loop_state("lost", lost_at)("late", late_at)("exploded", exploded_at)("rest", is_at_rest);
  }
};

}  // namespace transformesh
