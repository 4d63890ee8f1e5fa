/// Colors a surface from calibrated photographs, at its vertices or as a texture.
///
/// A vertex takes the colors of the photographs that show it best: not hidden by the surface, seen
/// along its normal, from nearby, and away from contours and borders. Exposures are adjusted.
/// Colors blend where the best view changes. If three or more photographs show a place well, those
/// that disagree, such as highlights, do not count. Detail finer than the edges is averaged.
/// Vertices that no view shows take the colors of their neighbors. The mesh need not be closed.
///
/// Cost: O(views * (pixels + faces + vertices)); memory: one photograph at a time, 20 bytes a
/// pixel, and 50 bytes a texel. The same bytes for any number of threads.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "transformesh/views.h"

namespace transformesh {

struct ColorResult {
  std::size_t unseen = 0;   ///< vertices that no view shows
  double disagreement = 0;  ///< mean difference from the photographs that show a vertex well
  double largest_gain = 1;  ///< factor by which the exposure of a photograph was changed at most
};

/// Writes the vertex columns red, green and blue, of bytes. `sources` names cameras and images.
/// Throws InputError if no view shows any of the mesh, and as read_views() does.
ColorResult color_vertices(Mesh& mesh, const ViewSources& sources, const Progress& progress = {});

struct AtlasOptions {
  int most_size = 4096;  ///< texels each way, 16 to 32768
  int padding = 4;       ///< texels around charts, 1 to 64
};

struct Atlas {
  Image picture;           ///< flat charts; a texel is as large as a pixel, or larger to fit
  std::size_t charts = 0;  ///< number of charts
  double texel = 0;        ///< length of a texel's side; input units
  ColorResult color;       ///< of the vertices
};

/// Makes a texture, and writes the face column `texcoord`: lists of u and v for each corner, v
/// upwards. Removes the colors of vertices. Throws UsageError for options out of range, GoalError
/// if the charts do not fit, and as color_vertices() does.
Atlas texture_surface(Mesh& mesh, const ViewSources& sources, const AtlasOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
