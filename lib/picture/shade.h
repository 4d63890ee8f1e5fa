/// Light and color for what a camera sees.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/linear_color.h"
#include "picture/surface_color.h"
#include "raster/camera.h"
#include "raster/rasterize.h"
#include "transformesh/image.h"

namespace transformesh {

struct ShadeOptions {
  SurfaceColorOptions color;
  Background background;
  double crease_angle_deg = 40;  ///< [0, 180]: bends beyond it are shaded as edges; 0 is flat
  /// Name of a vertex column as set_openness() makes it, which dims the light on front sides. None
  /// where empty or where the mesh has none of that name.
  std::string openness;
  /// The key light is a lamp of 8 degrees that faces keep off each other, and off a floor where one
  /// is given, by its height along `upright`: what is seen of that is its shadow alone.
  bool soft_shadow = false;
  std::optional<double> floor;
  bool draw_edges = false;                      ///< lines along the edges of faces, one pixel wide
  std::vector<std::pair<Vec3, Vec3>> segments;  ///< drawn where no surface hides them
  Vec3 upright = Vec3::UnitY();                 ///< where the sky is; length 1
  int samples = 3;  ///< [1, 8] each way in a pixel, against jagged outlines
};

/// A picture of camera.width x camera.height pixels. A mesh without faces shows the background.
/// Throws UsageError where the column to highlight is missing. Cost: O(faces + pixels * samples^2)
/// time; 4 bytes a pixel, 200 a face, and 2 MB a thread for the samples of a few rows, or one row's
/// where that is more; 55 MB for a soft shadow. Parallel; the same bytes for any number of threads.
Image shade(const Mesh& mesh, const Camera& camera, const ShadeOptions& options = {});

/// The same as a part of an image, which has room for it to the right of and below (left, above).
void shade(const Mesh& mesh, const Camera& camera, const ShadeOptions& options, int left, int above,
           Image& image);

}  // namespace transformesh
