/// Colors a surface from calibrated photographs, at its vertices or by a texture.
///
/// A vertex takes the colors of the photographs that observe it best: unoccluded, along its normal,
/// from nearby, and away from contours and borders. Exposures are equalized. Colors are blended
/// where the best view changes. If three or more photographs observe a vertex well, those that
/// disagree with the others, for example at highlights, are left out. Detail finer than the edges
/// is averaged. Vertices that are visible in no view take the colors of their neighbors. The mesh
/// may be open.
///
/// Cost: O(views * (pixels + faces + vertices)). Memory: one photograph at a time with 20 bytes per
/// pixel, and 50 bytes per texel. Deterministic for any number of threads.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "transformesh/views.h"

namespace transformesh {

struct ColorResult {
  std::size_t unseen = 0;  ///< vertices that are visible in no view
  /// Mean difference of the color of a vertex from the photographs that observe the vertex well; 0
  /// to 255.
  double disagreement = 0;
  double largest_gain = 1;  ///< largest factor of the exposure correction of a photograph
};

/// Writes the vertex columns red, green and blue, of type uint8. `sources` names cameras and
/// images. Throws InputError if the mesh is visible in no view, and as read_views() does.
ColorResult color_vertices(Mesh& mesh, const ViewSources& sources, const Progress& progress = {});

struct AtlasOptions {
  int most_size = 4096;  ///< largest width and height, in texels; 16 to 32768
  int padding = 4;       ///< width of the margin around charts, in texels; 1 to 64
};

struct Atlas {
  /// Texture with all charts. Texels have the size of a photograph's pixel, or are larger if this
  /// is needed to fit.
  Image picture;
  std::size_t charts = 0;  ///< number of charts
  double texel = 0;        ///< length of a texel's side; input units
  ColorResult color;       ///< result of color_vertices()
};

/// Makes a texture, and writes the face column `texcoord`: lists of (u, v) per corner, v upwards.
/// Removes vertex colors. Throws UsageError for options out of range, GoalError if the charts do
/// not fit, and as color_vertices() does.
Atlas texture_surface(Mesh& mesh, const ViewSources& sources, const AtlasOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
