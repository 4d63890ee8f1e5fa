/// The options of photoconsistency steps.
#pragma once

#include <string>

#include "frame/run.h"
#include "options/view_options.h"
#include "views/cameras/view_files.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace transformesh::tool {

/// Values of the options on the command line.
struct PhotoOptions {
  ViewSources sources;
  ViewCheckChoices check;
  double scale = 1;
  PairOptions pairs;
  PhotoStepsOptions steps;
};

void declare_photo_step(Program& program, PhotoOptions& options);

/// Reads the views, and reduces their photographs by the factor `scale`. If masks are exact, checks
/// whether the silhouettes of the views agree.
PhotoScene read_scene(const PhotoOptions& options, Run& run);

}  // namespace transformesh::tool
