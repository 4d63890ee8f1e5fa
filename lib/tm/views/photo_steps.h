/// Several steps towards photographs in a row, photo_step.h, on the same faces.
#pragma once

#include "tm/views/photo_step.h"

namespace transformesh {

struct PhotoStepsOptions {
  PhotoStepOptions step;
  int iterations = 1;  ///< >= 1
  /// Compare a pair of views in one order only, the lower index first, and in the next step the
  /// other way round: half the work, and as good after a few steps.
  bool alternate = false;
};

struct PhotoStepsResult {
  PhotoStepResult first;
  PhotoStepResult last;
  /// The last step compares more than a fifth fewer pixels than the first one of the same order of
  /// pairs did: a surface may also look consistent because little of it is seen.
  bool lost_coverage = false;
};

/// Throws as photo_step() does, and UsageError for less than one iteration.
PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene,
                             const PhotoStepsOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
