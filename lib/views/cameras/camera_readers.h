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
  const char* program;  ///< the program that writes such files, or the name of the format
  /// `stem` is the name of cameras without a name.
  CameraList (*read)(const Source& source, const std::string& stem);
};

/// Returns the row of the table; COLMAP's text for its binary model.
const CameraReader& reader_of(CameraFormat format);

/// Returns a clause that lists all formats, for messages.
std::string known_camera_formats();

}  // namespace transformesh
