/// Reads camera files. The format is recognized by the content; the source file of each reader
/// describes its format. Middlebury's files are described in middlebury.h.
///
/// All readers throw InputError, naming the file and the line or entry, if a camera is not a
/// pinhole with radial and tangential distortion (raster/lens_distortion.h). They also throw if a
/// number is missing, malformed, not finite or beyond 1e100, and if counts disagree. A focal length
/// that is negligible compared with the principal point is an error, too.
#pragma once

#include <string>
#include <string_view>

#include "raster/camera_record.h"
#include "views/cameras/camera_format.h"

namespace transformesh {

/// Reads cameras from a text, which must be complete in itself. `name` is the name of the text in
/// messages. Matrices without names are named after `stem`, or after the stem of `name` if `stem`
/// is empty.
CameraList parse_cameras(std::string_view bytes, const std::string& name,
                         const std::string& stem = {});

/// Reads cameras from a file, a folder or a pattern, in the order of the files. Several files are
/// sorted in natural order. In a folder, only files that look like camera files are read; they must
/// have the same format. If a folder has no camera file, the subfolders are searched in which
/// programs put camera files (camera_place.h).
CameraList cameras_from(const std::string& where);

}  // namespace transformesh
