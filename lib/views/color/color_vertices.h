/// Colors of vertices from calibrated photographs.
///
/// A vertex gets its color from the views that observe it best. In these views the vertex is not
/// occluded and is observed from nearby and along its normal. It is not close to contours or
/// borders of the image (photograph_sampler.h). Exposures are compensated
/// (exposure_compensation.h). Colors are blended where the best view changes. If three or more
/// views are good, those that disagree, such as highlights, do not count (best_view_colors.h).
/// Detail finer than the edges is averaged. Vertices that are not visible in any view get the
/// colors of their neighbors.
///
/// The mesh need not be closed. Cost: O(views * (pixels + faces + vertices)). Memory: one
/// photograph at a time, 20 bytes per pixel. The result does not depend on the number of threads.
#pragma once

#include <span>

#include "transformesh/color.h"
#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "views/cameras/view_files.h"

namespace transformesh {

/// Writes the vertex columns red, green and blue, of bytes; existing ones are replaced. Throws
/// InputError if the mesh is in front of no camera, or not visible in any view. Throws what
/// PictureView::picture throws.
ColorResult color_vertices(Mesh& mesh, std::span<const PictureView> views,
                           const Progress& progress = {});

}  // namespace transformesh
