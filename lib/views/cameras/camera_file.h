/// Reads camera files. The format is recognized by the content of a file. Each format is described
/// in the source file of its reader, except for Middlebury's format (middlebury.h).
///
/// All readers throw InputError, with the file and the line or entry, if a camera is not a pinhole
/// camera with radial and tangential distortion (raster/lens_distortion.h). They also throw it if a
/// number is missing, malformed, not finite or beyond 1e100. The same applies if a file contains
/// more or fewer cameras than it states, or if a focal length is negligible compared with the
/// principal point.
#pragma once

#include <string>
#include <string_view>

#include "raster/camera_record.h"
#include "views/cameras/camera_format.h"

namespace transformesh {

/// Reads cameras from the content of a single file, which must not need other files. `name` is the
/// name of the file in messages. Cameras that have no name in the file are named after `stem`. If
/// `stem` is empty, they are named after `name` without folder and extension.
CameraList parse_cameras(std::string_view bytes, const std::string& name,
                         const std::string& stem = {});

/// Reads cameras from a file, a folder, or the files that match a pattern. Several files are read
/// in natural order. In a folder, only files that look like camera files are read; they must have
/// the same format. If a folder has no camera file, reads the subfolder in which a program has put
/// camera files (camera_place.h).
CameraList cameras_from(const std::string& where);

}  // namespace transformesh
