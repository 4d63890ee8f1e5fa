/// Reads the views (cameras and photographs) that a reconstruction has written to its run folder
/// (run_views.h).
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"

namespace transformesh {

struct RunView {
  CameraRecord camera;     ///< camera of the view; includes the image size if there is a photograph
  std::string photograph;  ///< photograph as bytes of a PNG file; may be empty
};

/// Returns the views of a run, or of one of its time steps. The result may be empty. Throws
/// InputError if the cameras cannot be read.
std::vector<RunView> read_run_views(const std::string& folder);

}  // namespace transformesh
