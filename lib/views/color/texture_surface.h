/// Makes a texture of a surface from calibrated photographs. The texture is an atlas of planar
/// charts (charts.h). Its pixels (texels) are colored like vertices (color_vertices.h).
///
/// Texels have the size of a photograph's pixel at the mesh. They are larger if the atlas would
/// otherwise exceed AtlasOptions::most_size. Around each chart are texels that repeat its border,
/// so that reduced versions of the texture do not mix charts with other colors. Texels that are not
/// visible in any view are interpolated from the colors of vertices.
///
/// Time: like color_vertices(), but for each texel instead of each vertex. Memory: 50 bytes per
/// texel and 20 bytes per pixel of one photograph. The result does not depend on the number of
/// threads.
#pragma once

#include "transformesh/image.h"
#include "views/cameras/view_files.h"
#include "views/color/color_vertices.h"

namespace transformesh {

/// Writes the face column `texcoord`: for each face, the list of u and v of its corners as floats;
/// v points upwards. Removes the vertex columns red, green, blue and alpha, because viewers would
/// multiply the texture by these colors. Throws UsageError if options are out of range, GoalError
/// if the charts do not fit into the largest atlas, and what color_vertices() throws.
Atlas texture_surface(Mesh& mesh, std::span<const PictureView> views,
                      const AtlasOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
