/// A texture of a surface from calibrated photographs: an atlas of flat charts (charts.h), whose
/// texels are colored as vertices are (color_vertices.h).
///
/// Texels are as large as a pixel is where the mesh is, or larger where the atlas would be larger
/// than it may be. Around each chart some texels repeat its border, so that nothing shines through
/// between charts when the texture is made smaller. What no view sees has the vertices' colors.
///
/// Cost: as color_vertices, for texels; memory 50 bytes a texel and 20 bytes a pixel of one
/// photograph. The same bytes for any number of threads.
#pragma once

#include "transformesh/image.h"
#include "views/cameras/view_files.h"
#include "views/color/color_vertices.h"

namespace transformesh {

/// Writes the face column `texcoord`, lists of u and v, v upwards, of each corner, as floats; takes
/// away red, green, blue and alpha of the vertices, by which viewers would darken the texture.
/// Throws UsageError for options out of range, GoalError where no atlas of that size has room, and
/// what color_vertices does.
Atlas texture_surface(Mesh& mesh, std::span<const PictureView> views,
                      const AtlasOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
