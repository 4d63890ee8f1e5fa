/// The views of a reconstruction in the folder of its run (run_folder.h): the cameras as Middlebury
/// parameters, and small photographs, `photographs/000-640x480.png` and so on in the order of the
/// cameras, whose names hold the size of the image that the camera is of.
#pragma once

#include <span>

#include "evolution/loop/run_folder.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Names and bytes for begin_run(); of a time step, from 1 on, for add_to_run(). The cameras are
/// last. Blanks in names of views become `_`, and equal names are numbered. Photographs are gray
/// and at most 320 pixels wide and high. Deterministic.
RunFiles run_files_of(std::span<const View> views, std::size_t step = 0);

}  // namespace transformesh
