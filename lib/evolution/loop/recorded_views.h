/// Reads the views that a reconstruction has kept in the folder of its run (run_views.h writes
/// them).
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"

namespace transformesh {

struct RunView {
  CameraRecord camera;     ///< with the image's size where there is its photograph
  std::string photograph;  ///< PNG, or empty
};

/// Returns the views of a run, or of one of its time steps; none where the folder has none. Throws
/// InputError for cameras that cannot be read.
std::vector<RunView> read_run_views(const std::string& folder);

}  // namespace transformesh
