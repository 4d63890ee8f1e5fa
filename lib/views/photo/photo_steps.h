/// Several steps towards photographs (photo_step.h) in a row, on the same faces.
///
/// With momentum a step also goes on with a share of the movement before it, but for the last one:
/// where steps are small and agree, as where noise is most of what photographs show, the surface
/// gets there in a fraction of them, while movements to and fro cancel.
/// Reference: Polyak, "Some methods of speeding up the convergence of iteration methods", USSR
/// Computational Mathematics and Mathematical Physics 4(5), 1964.
#pragma once

#include "views/photo/photo_scene.h"
#include "views/photo/scene_step.h"

namespace transformesh {

struct PhotoStepsOptions {
  PhotoStepOptions step;
  int iterations = 1;  ///< >= 1
  /// Compare a pair of views in one order only, the lower index first, and in the next step the
  /// other way round: half the work, and as good after a few steps.
  bool alternate = false;
  double momentum = 0;  ///< [0, 1): the share
};

struct PhotoStepsResult {
  PhotoStepResult first;
  PhotoStepResult last;
  /// A surface may also look consistent because little of it is compared. Set where, from the first
  /// to the last step of the same order of pairs, the share of the visible pixels that are compared
  /// fell by a tenth or more, or the number of those compared by half. The share does not mind that
  /// a surface becomes smaller.
  bool lost_coverage = false;
};

/// Throws as photo_step() does, and UsageError for less than one iteration and a momentum out of
/// range.
PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene,
                             const PhotoStepsOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
