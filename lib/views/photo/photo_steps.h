/// Several consecutive steps towards photographs (photo_step.h), without remeshing in between.
///
/// If `momentum` is above 0, each step except the last also repeats this fraction of the previous
/// movement. Small steps in the same direction, which are typical of noisy photographs, add up; the
/// surface then converges in fewer steps. Movements in opposite directions cancel.
/// Reference: Polyak, "Some methods of speeding up the convergence of iteration methods", USSR
/// Computational Mathematics and Mathematical Physics 4(5), 1964.
#pragma once

#include "views/photo/photo_scene.h"
#include "views/photo/scene_step.h"

namespace transformesh {

struct PhotoStepsOptions {
  PhotoStepOptions step;
  int iterations = 1;  ///< >= 1
  /// If true, steps alternate between the two orders of each pair of views, instead of using both
  /// in each step. The first step uses pairs in which the reference view has the lower index.
  /// Halves the work per step; results are as good after a few steps.
  bool alternate = false;
  double momentum = 0;  ///< fraction of the previous movement that is repeated; [0, 1)
};

struct PhotoStepsResult {
  PhotoStepResult first;
  PhotoStepResult last;
  /// True if much less of the surface is compared after the steps than before; then a low energy
  /// does not mean that photographs agree. Compares the first and the last step with the same order
  /// of pairs. Coverage is lost if the compared fraction of the visible pixels falls by a tenth, or
  /// if their number falls by half. The fraction does not depend on the size of the surface.
  bool lost_coverage = false;
};

/// Throws as photo_step() does. Throws UsageError if the number of iterations or the momentum is
/// out of range.
PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene,
                             const PhotoStepsOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
