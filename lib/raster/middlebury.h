/// Camera files of the Middlebury multi-view datasets: the number of cameras, then one line `name
/// k11 .. k33 r11 .. r33 t1 t2 t3` per camera. `#` begins a comment.
/// Reference: Seitz, Curless, Diebel, Scharstein & Szeliski, "A comparison and evaluation of
/// multi-view stereo reconstruction algorithms", CVPR 2006.
#pragma once

#include <string>

#include "io/streams/source.h"
#include "raster/camera_record.h"

namespace transformesh {

/// Throws InputError, naming file and line, if numbers are missing or do not describe a camera.
CameraList read_middlebury(const Source& source);

/// Returns text from which read_middlebury() reads the same cameras. Throws InputError if a name
/// contains blanks or `#`, or if a camera is not valid (check_read_again()).
std::string write_middlebury(const CameraList& list);

}  // namespace transformesh
