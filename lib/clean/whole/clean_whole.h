/// Cleans a whole mesh: arrangement, exterior, stitching and rounding, then the options
/// `merge_flat` and `outermost`. Ignores `separate`, `sources`, `box` and `only`, which clean()
/// handles. Throws what clean() throws.
#pragma once

#include "clean/pass/piece_chooser.h"
#include "transformesh/clean.h"

namespace transformesh {

CleanResult clean_whole(const Mesh& mesh, const CleanOptions& options, const Progress& progress);
/// Cleans the mesh such that the result is the boundary of the region that `chooser` selects.
CleanResult clean_region(const Mesh& mesh, const CleanOptions& options, const PieceChooser& chooser,
                         const Progress& progress);

}  // namespace transformesh
