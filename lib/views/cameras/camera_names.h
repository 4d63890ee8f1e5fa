/// Shortens names of cameras that are paths of images, perhaps on another computer.
#pragma once

#include "raster/camera_record.h"

namespace transformesh {

/// Removes from the names of cameras the folder that contains all of them, such as `/home/a/photos`
/// or `C:\photos`. Backslashes become slashes. The rest of a name still identifies an image:
/// `left/1.jpg` and `right/1.jpg`, or `1.jpg` and `2.jpg`.
void remove_common_folder(CameraList& list);

}  // namespace transformesh
