/// Colors vertices of a mesh by calibrated photographs.
///
/// A vertex gets its color from the views that observe it best. In these views, the vertex is not
/// occluded, and the camera is near and looks along the normal. The vertex is not close to contours
/// of the mesh or borders of the image (photograph_sampler.h). Exposures are compensated
/// (exposure_compensation.h). Colors are blended at places where the best view changes. If three or
/// more views are good, colors that disagree with the others, such as highlights, hardly count
/// (best_view_colors.h). Detail of photographs that is finer than the edges of the mesh is
/// averaged. Vertices that are not visible in any view get the colors of their neighbors.
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

/// Writes the vertex columns red, green and blue, of type byte; replaces existing columns of these
/// names. Throws InputError if the mesh is in front of no camera, or not visible in any view.
/// Throws what PictureView::picture throws.
ColorResult color_vertices(Mesh& mesh, std::span<const PictureView> views,
                           const Progress& progress = {});

}  // namespace transformesh
