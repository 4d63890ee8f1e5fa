/// The table of camera formats, with the name and the reader of each format. Used only in this
/// folder.
#pragma once

#include <string>

#include "io/streams/source.h"
#include "raster/camera_record.h"
#include "views/cameras/camera_format.h"

namespace transformesh {

struct CameraReader {
  CameraFormat format;
  const char* program;  ///< the program that writes files of this format, or the name of the format
  /// Reads a file of this format. Cameras that have no name in the file are named after `stem`.
  CameraList (*read)(const Source& source, const std::string& stem);
};

/// Returns the table's row for the format. COLMAP's binary and text formats share a row.
const CameraReader& reader_of(CameraFormat format);

/// Returns a list of all formats as text, for messages.
std::string known_camera_formats();

}  // namespace transformesh
