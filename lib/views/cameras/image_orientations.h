/// Checks for photographs whose Exif data ask viewers to turn them.
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"
#include "transformesh/views.h"

namespace transformesh {

/// Checks the Exif orientations of the images at `paths`, one for each camera. Pixels are used as
/// they are stored, because most programs calibrate cameras for them; `sources.on_note` is told if
/// a file states another orientation. Throws InputError if the size of a camera shows that it was
/// calibrated for the turned picture.
void check_orientations(const std::vector<std::string>& paths, const CameraList& cameras,
                        const ViewSources& sources);

}  // namespace transformesh
