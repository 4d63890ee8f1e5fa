/// The table from formats of camera files to their names and readers. Internal to camera_file and
/// camera_output.
#pragma once

#include <string>

#include "io/streams/source.h"
#include "raster/camera_record.h"
#include "views/cameras/camera_format.h"

namespace transformesh {

struct CameraReader {
  CameraFormat format;
  const char* program;  ///< the program that writes files of this format, or the name of the format
  /// Cameras that have no name in the file are named after `stem`.
  CameraList (*read)(const Source& source, const std::string& stem);
};

/// Returns the table's row of the format. COLMAP's binary model has the row of its texts.
const CameraReader& reader_of(CameraFormat format);

/// Returns a clause that lists all formats, for messages.
std::string known_camera_formats();

}  // namespace transformesh
