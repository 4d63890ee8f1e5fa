/// Colors of vertices from calibrated photographs.
///
/// Each vertex takes what the views show that see it best: not hidden by the surface itself, most
/// squarely, from nearest by, and away from contours and borders (photograph_sampler.h). Exposures
/// are evened out (exposure_compensation.h). Where the best view changes, colors blend; where three
/// or more see a place well, the ones that disagree, as highlights do, do not count
/// (best_view_colors.h). Detail finer than the edges is averaged. Vertices that no view sees take
/// the colors of their neighbors.
///
/// The mesh need not be closed. Cost: O(views * (pixels + faces + vertices)); memory: one
/// photograph at a time, 20 bytes a pixel. The same bytes for any number of threads.
#pragma once

#include <span>

#include "mesh/mesh.h"
#include "support/progress.h"
#include "views/cameras/view_files.h"

namespace transformesh {

struct ColorResult {
  std::size_t unseen = 0;  ///< vertices that no view sees
  /// Mean difference of the colors, in intensities, from the photographs that see them well.
  double disagreement = 0;
  double largest_gain =
      1;  ///< exposure_compensation.h: by which a photograph was brightened or darkened
};

/// Writes the columns red, green and blue, of bytes, in the place of any that are there. Throws
/// InputError where the mesh is before no camera or no view sees any of it, and what
/// PictureView::picture does.
ColorResult color_vertices(Mesh& mesh, std::span<const PictureView> views,
                           const Progress& progress = {});

}  // namespace transformesh
