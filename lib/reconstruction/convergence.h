/// Whether the end of a reconstruction is to be believed: converged is what has no fault.
#pragma once

#include <string>

#include "evolution/loop/loop_state.h"
#include "reconstruction/surface_doubt.h"

namespace transformesh {

/// What the end of a reconstruction is judged by, beside its sweeps.
struct SurfaceEvidence {
  double first_agreement = 1;  ///< initial mesh and exact masks; mean over the views
  double agreement = 1;        ///< of the result
  SurfaceDoubt doubt;
};

/// What keeps the end of a reconstruction from being converged.
struct ReconstructionFaults {
  double lost_at = 0;  ///< scale after which less of the surface was compared than before; 0: none
  double late_at = 0;  ///< scale at which the topology changed late; 0: none
  bool is_at_rest = false;

  /// The first one, empty where there is none. Beside the above: the outline agrees with masks by
  /// 0.005 less than that of the initial mesh, photographs disagree by more than 0.2 beyond their
  /// noise or on more than 3 % of what is seen, or a thin place is doubtful.
  std::string in_words(const SurfaceEvidence& evidence) const;
  void remember(LoopState& loop_state) {
    loop_state("lost", lost_at)("late", late_at)("rest", is_at_rest);
  }
};

}  // namespace transformesh
