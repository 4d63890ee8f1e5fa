/// Cleans a whole mesh: arrangement, exterior, stitching and rounding, then `outermost`. Ignores
/// `separate`, `sources`, `box` and `only`, which clean() adds. Throws what clean() throws.
#pragma once

#include "clean/pass/piece_chooser.h"
#include "transformesh/clean.h"

namespace transformesh {

CleanResult clean_whole(const Mesh& mesh, const CleanOptions& options, const Progress& progress);
/// The same for the region of another operation.
CleanResult clean_region(const Mesh& mesh, const CleanOptions& options, const PieceChooser& chooser,
                         const Progress& progress);

}  // namespace transformesh
