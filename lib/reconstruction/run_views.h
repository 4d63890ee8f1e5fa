/// Stores the views of a reconstruction in the folder of its run (run_folder.h). These are the
/// cameras in a Middlebury file, and small photographs, named `photographs/000-640x480.png` and so
/// on, in the order of the cameras. The name of a photograph contains the size of the full image.
#pragma once

#include <span>

#include "evolution/loop/run_folder.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Returns names and contents of the files for begin_run() or, if `step` is the number of a time
/// step (1 or more), for add_to_run(). The camera file is the last one. Blanks in names of views
/// become `_`, and equal names are numbered. Photographs are gray, and at most 320 pixels wide and
/// high. Deterministic.
RunFiles run_files_of(std::span<const View> views, std::size_t step = 0);

}  // namespace transformesh
