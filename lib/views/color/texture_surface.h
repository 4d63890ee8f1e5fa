/// A texture of a surface from calibrated photographs: an atlas of planar charts (charts.h), whose
/// texels are colored like vertices (color_vertices.h).
///
/// Texels have the size of a pixel at the mesh, or are larger if the atlas would exceed its limit.
/// Charts are padded by texels that repeat their border, so that colors between charts do not bleed
/// into reduced versions of the texture. Texels that are not visible in any view are interpolated
/// from the colors of vertices.
///
/// Cost: as color_vertices, for texels. Memory: 50 bytes per texel and 20 bytes per pixel of one
/// photograph. The result does not depend on the number of threads.
#pragma once

#include "transformesh/image.h"
#include "views/cameras/view_files.h"
#include "views/color/color_vertices.h"

namespace transformesh {

/// Writes the face column `texcoord`: lists of u and v of each corner as floats, v upwards. Removes
/// red, green, blue and alpha of the vertices, because viewers would multiply the texture by them.
/// Throws UsageError if options are out of range, GoalError if the charts do not fit into the
/// largest atlas, and what color_vertices() throws.
Atlas texture_surface(Mesh& mesh, std::span<const PictureView> views,
                      const AtlasOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
