/// Cleans a whole mesh: arrangement, exterior, stitching and rounding, then `outermost`. Ignores
/// `separate`, `sources`, `box` and `only`, which clean() adds. Throws what clean() throws.
#pragma once

#include "transformesh/clean.h"

namespace transformesh {

CleanResult clean_whole(const Mesh& mesh, const CleanOptions& options, const Progress& progress);

}  // namespace transformesh
