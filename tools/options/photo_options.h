/// The options of photoconsistency steps.
#pragma once

#include <string>

#include "frame/run.h"
#include "options/view_options.h"
#include "views/cameras/view_files.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace transformesh::tool {

/// Values of the options on the command line that are not directly stored in `steps` and `pairs`.
struct PhotoOptions {
  ViewSources sources;
  ViewCheckChoices check;
  double scale = 1;
  long neighbors = static_cast<long>(PairOptions().neighbors);
  long window = CorrelationOptions().radius;
  long iterations = PhotoStepsOptions().iterations;
  std::string rule = "gauss-newton";
  std::string meaning = "exact";
  std::string interpolation = "catmull-rom";
  PairOptions pairs;
  PhotoStepsOptions steps;
};

void declare_photo_step(Program& program, PhotoOptions& options);

/// Reads the views, and reduces them by the factor `scale`. Checks whether views with exact masks
/// agree.
PhotoScene read_scene(const PhotoOptions& options, Run& run);

PhotoStepsOptions steps_of(const PhotoOptions& options);

}  // namespace transformesh::tool
