/// Several consecutive steps towards photographs (photo_step.h), without remeshing in between.
///
/// If `momentum` is above 0, each step except the last one adds this fraction of the previous
/// movement. Small movements in the same direction, which are typical of noisy photographs, add up,
/// so that the surface converges in fewer steps. Movements in opposite directions cancel.
/// Reference: Polyak, "Some methods of speeding up the convergence of iteration methods", USSR
/// Computational Mathematics and Mathematical Physics 4(5), 1964.
#pragma once

#include "views/photo/photo_scene.h"
#include "views/photo/scene_step.h"

namespace transformesh {

struct PhotoStepsOptions {
  PhotoStepOptions step;
  int iterations = 1;  ///< number of steps, >= 1
  /// True if steps use the two orders of each pair of views in turn, instead of both in each step.
  /// The first step uses pairs in which the reference view has the lower index. This halves the
  /// time of a step; after a few steps, results are as good.
  bool alternate = false;
  double momentum = 0;  ///< fraction of the previous movement that is added to each step; [0, 1)
};

struct PhotoStepsResult {
  PhotoStepResult first;
  PhotoStepResult last;
  /// True if much less of the surface is compared in the last step than in the first one. A low
  /// energy then does not mean that photographs agree. Coverage is lost if the compared fraction of
  /// the visible pixels falls by a tenth, or if the number of compared pixels falls by half. Uses
  /// the first and the last step with the same order of pairs.
  bool lost_coverage = false;
};

/// Moves the vertices by `options.iterations` steps. Throws as photo_step() does. Throws UsageError
/// if the number of iterations or the momentum is out of range.
PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene,
                             const PhotoStepsOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
