/// Camera files of the Middlebury multi-view datasets: the number of cameras, then a line
/// `name k11 .. k33 r11 .. r33 t1 t2 t3` for each; `#` begins a comment. Reference: Seitz, Curless,
/// Diebel, Scharstein & Szeliski, "A comparison and evaluation of multi-view stereo reconstruction
/// algorithms", CVPR 2006.
#pragma once

#include <string>

#include "io/streams/source.h"
#include "raster/camera_record.h"

namespace transformesh {

/// Throws InputError naming file and line for numbers that are missing or no camera's.
CameraList read_middlebury(const Source& source);

/// Text that reads back as the same cameras. Throws InputError for names with blanks or `#`, and
/// for cameras that the text cannot hold.
std::string write_middlebury(const CameraList& list);

}  // namespace transformesh
