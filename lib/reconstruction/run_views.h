/// Stores the views of a reconstruction in the folder of its run (run_folder.h). These are the
/// cameras as Middlebury parameters, and small photographs `photographs/000-640x480.png` and so on,
/// in the order of the cameras. The name of a photograph contains the size of the full image.
#pragma once

#include <span>

#include "evolution/loop/run_folder.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Returns names and bytes of files for begin_run(), or for add_to_run() if `step` is a time step
/// from 1 on. The cameras come last. Blanks in names of views become `_`, and equal names are
/// numbered. Photographs are gray, and at most 320 pixels wide and high. Deterministic.
RunFiles run_files_of(std::span<const View> views, std::size_t step = 0);

}  // namespace transformesh
