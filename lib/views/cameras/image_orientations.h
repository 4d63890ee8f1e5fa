/// Checks whether Exif data of photographs ask viewers to turn or mirror the pictures.
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"
#include "transformesh/views.h"

namespace transformesh {

/// Checks the Exif orientations of the images at `paths`, one for each camera. Pixels are used as
/// stored, because most programs calibrate cameras for stored pixels. Calls `sources.on_note` if
/// the Exif data of a file state another orientation. Throws InputError if the size of a camera's
/// image shows that the camera was calibrated for the turned picture.
void check_orientations(const std::vector<std::string>& paths, const CameraList& cameras,
                        const ViewSources& sources);

}  // namespace transformesh
